#include "gui/workbench/panels/plots_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QRegularExpression>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "gui/workbench/panels/ask_for_file.h"
#include "gui/workbench/panels/figure_image.h"
#include "gui/workbench/panels/figure_words.h"
#include "gui/workbench/panels/rich_label.h"
#include "gui/workbench/panels/tones.h"
#include "render/figures/control_loops.h"
#include "render/figures/figure_file.h"
#include "render/figures/figure_table.h"
#include "render/figures/own_channels.h"
#include "render/figures/paper_figures.h"

namespace netpocket {
namespace {

constexpr int kRedrawInterval = 50;  // ms
const QString kPicked = QStringLiteral("picked");
const QString kLoops = QStringLiteral("control_loops");

QColor on_screen(const FigureColour& colour, const QPalette& palette) {
  const QColor plain = QColor::fromRgbF(static_cast<float>(colour.red), static_cast<float>(colour.green),
                                        static_cast<float>(colour.blue));
  return is_dark(palette) ? mirrored_lightness(plain) : plain;
}

QString value_html(const Curve& curve, const QString& name, double value, const QPalette& palette) {
  const QString number = QString::number(value, 'g', 4).replace('-', QChar(0x2212));
  return QString("<span style='color:%1'>&#9632;</span>&nbsp;%2&nbsp;<b>%3</b>")
      .arg(on_screen(curve.colour, palette).name(), name, number);
}

// A name stays in one line with its value, also one in Chinese, which may else be broken at every letter.
QString in_one_line(QString name) {
  static const QRegularExpression kBetween(QStringLiteral("(?<=[\\x{2E80}-\\x{FFFF}])(?=[\\x{2E80}-\\x{FFFF}])"));
  return name.replace(' ', QChar::Nbsp).replace(kBetween, QString(QChar(0x2060)));
}

QStringList panel_values(const Panel& panel, double time, const QPalette& palette) {
  QStringList values;
  const bool labelled = std::ranges::any_of(
      panel.curves, [](const Curve& curve) { return curve.marker == Marker::none && !curve.label.empty(); });
  for (const Curve& curve : panel.curves) {
    if (curve.marker != Marker::none || (labelled && curve.label.empty())) continue;
    const auto value = value_at(curve, time);
    const std::string& name = curve.label.empty() ? panel.y.title : curve.label;
    if (value) values << value_html(curve, in_one_line(to_html(name)), *value, palette);
  }
  return values;
}

}  // namespace

PlotsPanel::PlotsPanel(QWidget* parent)
    : QWidget(parent),
      figures_(new QComboBox(this)),
      reset_(new QToolButton(this)),
      export_(new QToolButton(this)),
      chart_(new ChartView(this)),
      values_(new QLabel(this)) {
  add_figures();
  figures_->setToolTip(tr("What to plot"));
  figures_->setAccessibleName(tr("Figure"));
  reset_->setText(tr("All times"));
  reset_->setToolTip(tr("Show the whole run (double click in the plot)"));
  reset_->setEnabled(false);
  export_->setText(tr("Export…"));
  export_->setToolTip(tr("Save this figure as PNG, SVG or PDF"));
  chart_->set_placeholder(tr("Run the scenario or open a recording to see its plots here."));
  values_->setTextFormat(Qt::RichText);
  values_->setWordWrap(true);
  values_->setContentsMargins(8, 0, 8, 2);
  values_->setAlignment(Qt::AlignTop | Qt::AlignLeft);

  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(6, 6, 6, 0);
  bar->addWidget(figures_, 1);
  bar->addWidget(reset_);
  bar->addWidget(export_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(bar);
  layout->addWidget(chart_, 1);
  layout->addWidget(values_);

  throttle_.setSingleShot(true);
  throttle_.setInterval(kRedrawInterval);
  connect(&throttle_, &QTimer::timeout, this, &PlotsPanel::redraw);
  connect(figures_, &QComboBox::currentIndexChanged, this, [this] {
    values_->setMinimumHeight(0);
    redraw();
  });
  connect(reset_, &QToolButton::clicked, chart_, [this] { chart_->set_window(std::nullopt); });
  connect(export_, &QToolButton::clicked, this, &PlotsPanel::ask_for_export);
  connect(chart_, &ChartView::time_clicked, this, &PlotsPanel::time_clicked);
  connect(chart_, &ChartView::probed, this, &PlotsPanel::show_values);
  connect(chart_, &ChartView::window_changed, this, [this] { reset_->setEnabled(chart_->window().has_value()); });
  redraw();
}

void PlotsPanel::add_figures() {
  figures_->addItem(tr("Closing length and speed"), "figure03_closing");
  figures_->addItem(tr("Contact force on the target"), "figure05_force");
  figures_->addItem(tr("Positions of target and spacecraft"), "figure06_position");
  figures_->addItem(tr("Target, run by run"), "figure10_target_position");
  figures_->addItem(tr("Spacecraft, run by run"), "figure11_spacecraft_position");
  figures_->addItem(tr("Energy balance"), "energy");
  figures_->addItem(tr("Tensions"), "tension");
}

// Figures that no run has channels for are not offered.
void PlotsPanel::offer_figures() {
  const auto offer = [this](const QString& name, const QString& words, bool suits) {
    const int index = figures_->findData(name);
    if (!suits && index >= 0) figures_->removeItem(index);
    if (suits && index < 0) figures_->addItem(words, name);
  };
  offer(kLoops, tr("Control loops"), std::ranges::any_of(runs_, has_control_loops));
  offer("own_channels", tr("Channels of the system"), std::ranges::any_of(runs_, has_own_channels));
}

void PlotsPanel::set_series(std::vector<RunSeries> runs) {
  runs_ = std::move(runs);
  offer_figures();
  request_redraw();
}

void PlotsPanel::append(std::size_t run, const std::vector<double>& channels) {
  if (run >= runs_.size()) return;
  runs_[run].append(channels);
  request_redraw();
}

void PlotsPanel::describe(std::size_t run, const RunSeries& series) {
  if (run >= runs_.size()) return;
  RunSeries& shown = runs_[run];
  if (shown.channel_list == series.channel_list && shown.phases == series.phases) return;
  if (shown.channel_list != series.channel_list) {
    shown.begin(series.channel_list);
    shown.loops = series.loops;
    shown.draft = series.draft;
    offer_figures();
  }
  shown.phases = series.phases;
  request_redraw();
}

void PlotsPanel::set_picked(std::vector<Panel> panels) {
  picked_ = std::move(panels);
  const int index = figures_->findData(kPicked);
  if (picked_.empty() && index >= 0) figures_->removeItem(index);
  if (!picked_.empty() && index < 0) figures_->addItem(tr("Picked items"), kPicked);
  request_redraw();
}

void PlotsPanel::set_loop(const QString& name) {
  if (name == loop_) return;
  loop_ = name;
  if (figure_name() == kLoops) request_redraw();
}

void PlotsPanel::set_time(std::optional<double> time) {
  chart_->set_cursor(time);
  show_values();
}

void PlotsPanel::show_figure(const QString& name) {
  const int index = figures_->findData(name);
  if (index >= 0) figures_->setCurrentIndex(index);
}

QString PlotsPanel::figure_name() const { return figures_->currentData().toString(); }

void PlotsPanel::request_redraw() {
  stale_ = true;
  if (isVisible() && !throttle_.isActive()) throttle_.start();
}

void PlotsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) redraw();
}

void PlotsPanel::redraw() {
  stale_ = false;
  Figure figure = in_window_language(make_figure());
  figure.note.clear();  // the status bar says it, and there is little room
  chart_->set_figure(std::move(figure));
  export_->setEnabled(time_range(chart_->figure()).has_value());
  show_values();
}

Figure PlotsPanel::make_figure() const {
  if (figure_name() == kPicked) {
    Figure figure;
    figure.panels = picked_;
    figure.columns = 2;
    return figure;
  }
  if (figure_name() == kLoops && !runs_.empty()) return control_loop_figure(runs_, loop_.toStdString());
  return netpocket::make_figure(figure_name().toStdString(), runs_);
}

void PlotsPanel::show_values() {
  const auto time = chart_->probe_time() ? chart_->probe_time() : chart_->cursor_time();
  QStringList parts;
  if (time) {
    parts << QString("<i>t</i>&nbsp;=&nbsp;<b>%1</b>&nbsp;s").arg(*time, 0, 'f', 2);
    const std::vector<Panel>& panels = chart_->figure().panels;
    for (std::size_t i = 0; i < panels.size(); ++i) {
      QStringList values = panel_values(panels[i], *time, palette());
      if (panels.size() > 1 && !values.isEmpty())
        values.front().prepend(QString("(%1)&nbsp;").arg(QChar('a' + int(i))));
      parts << values;
    }
  }
  values_->setText(parts.join(QStringLiteral(" &nbsp; ")));
  // Grows with the longest text but does not shrink with every movement of the mouse, which would move the chart.
  const int height = std::max(values_->heightForWidth(std::max(values_->width(), 1)), fontMetrics().height() + 6);
  if (height > values_->minimumHeight()) values_->setMinimumHeight(height);
}

QString PlotsPanel::values_text() const { return values_->text(); }

std::optional<QString> PlotsPanel::export_figure(const QString& path) const {
  Figure figure = make_figure();
  if (const auto window = chart_->window()) figure = cut(figure, *window);
  if (const auto range = chart_->window() ? chart_->window() : time_range(figure)) share_time(figure, *range);
  try {
    const std::filesystem::path file(path.toStdString());
    if (file.extension() == ".csv") {
      save_figure_csv(figure, file);
    } else {
      save_figure(figure, file);
    }
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
  return std::nullopt;
}

void PlotsPanel::ask_for_export() {
  const FileQuestion question = {tr("Export figure"), figure_name() + ".pdf",
                                 tr("PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Numbers (*.csv)"), "pdf"};
  ask_for_file(this, question, [this](const QString& path) {
    const auto problem = export_figure(path);
    if (problem) {
      emit export_failed(*problem);
    } else {
      emit exported(path);
    }
  });
}

}  // namespace netpocket
