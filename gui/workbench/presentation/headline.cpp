#include "gui/workbench/presentation/headline.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/state/phase.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/findings_panel.h"
#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

// Against the headline's own letters.
constexpr double kNameScale = 1.2, kValueScale = 1.5, kCaptionScale = 0.75;
constexpr double kSmallest = 0.55;  // of the scale at which everything fits
constexpr double kGap = 1.4;        // between numbers, in heights of a line
constexpr int kNameUnits = 7;       // room for the name at least, in heights of a line

void set_size(QLabel& label, const QFont& base, double scale, bool bold) {
  QFont font;
  font.setPointSizeF(scale * base.pointSizeF());
  font.setBold(bold);
  label.setFont(font);
}

void set_colour(QLabel& label, const QColor& colour) {
  QPalette palette;
  palette.setColor(QPalette::WindowText, colour);
  label.setPalette(palette);
}

// "1.24 kN": three digits, whatever the size.
QString force_words(double newtons) {
  if (newtons >= 999.5) return Headline::tr("%1 kN").arg(newtons / 1000, 0, 'f', newtons < 9995 ? 2 : 1);
  return Headline::tr("%1 N").arg(newtons, 0, 'f', newtons < 9.95 ? 1 : 0);
}

QString capitalised(const std::string& word) {
  QString text = engine_words(word);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

// Of a channel that not every run has.
std::optional<double> value_at(const Run& run, Channel channel, std::size_t frame) {
  const auto& values = run.series.channel(channel);
  return frame < values.size() ? std::optional(values[frame]) : std::nullopt;
}

QString contact_force(const Run& run, std::size_t frame) {
  const auto x = value_at(run, Channel::contact_fx, frame), y = value_at(run, Channel::contact_fy, frame),
             z = value_at(run, Channel::contact_fz, frame);
  return x && y && z ? force_words(std::hypot(*x, *y, *z)) : QString();
}

}  // namespace

Headline::Headline(QWidget* parent)
    : QWidget(parent), row_(new QHBoxLayout(this)), tiles_(new QGridLayout), name_(new QLabel) {
  setAccessibleName(tr("Numbers of the shown moment"));
  name_->setTextFormat(Qt::PlainText);
  name_->setToolTip(tr("The run that is shown"));
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row_->addWidget(name_, 1);
  row_->addLayout(tiles_);
  tiles_->setVerticalSpacing(0);
  time_ = add_tile(tr("Time"), "000.00 s");
  phase_ = add_tile(tr("Phase"), "closing");
  mouth_ = add_tile(tr("Radius of the mouth"), "0.00 m");
  force_ = add_tile(tr("Contact force"), "0.00 kN");
  capture_ = add_tile(tr("Target"), {});
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  set_sizes(1);
  follow_palette();
  hide();
}

Headline::Tile Headline::add_tile(const QString& caption, const QString& widest) {
  const Tile tile{new QLabel(caption), new QLabel, widest};
  tile.value->setTextFormat(Qt::PlainText);
  const int column = tiles_->columnCount();
  tiles_->addWidget(tile.caption, 0, column);
  tiles_->addWidget(tile.value, 1, column);
  return tile;
}

void Headline::add_corner(QWidget* corner) { row_->addWidget(corner); }

void Headline::show_value(const Tile& tile, const QString& value) {
  tile.value->setText(value);
  tile.value->setVisible(!value.isEmpty());
  tile.caption->setVisible(!value.isEmpty());
}

void Headline::show_run(const Run* run, std::size_t frame, const QString& name) {
  const bool any = run != nullptr && run->frame_count() > 0;
  const QString shown_name = any ? run->name : name;
  const bool renamed = std::exchange(whole_name_, shown_name) != shown_name;
  if (!any) {
    for (const Tile& tile : {time_, mouth_, force_, capture_}) show_value(tile, {});
    show_value(phase_, tr("Not simulated yet"));
    return fit();
  }
  const std::size_t shown = std::min(frame, run->frame_count() - 1);
  const double time = run->series.times()[shown];
  show_value(time_, tr("%1 s").arg(time, 0, 'f', 2));
  show_value(phase_, capitalised(phase_at(run->series.phases, time)));
  const auto radius = value_at(*run, Channel::mouth_radius, shown);
  show_value(mouth_, radius && std::isfinite(*radius) ? tr("%1 m").arg(*radius, 0, 'f', 2) : QString());
  show_value(force_, contact_force(*run, shown));
  show_capture();
  if (renamed || row_->minimumSize().width() > width()) fit();
}

void Headline::set_capture(Verdict captured) {
  captured_ = captured;
  if (!time_.value->text().isEmpty()) show_capture();
}

void Headline::show_capture() {
  const CaptureWords words = capture_words(captured_);
  show_value(capture_, words.brief);
  set_colour(*capture_.value,
             words.tone == Tone::muted ? palette().color(QPalette::Text) : tone_colour(words.tone, palette()));
}

QString Headline::text() const {
  QStringList words{whole_name_};
  for (const Tile& tile : {time_, phase_, mouth_, force_, capture_}) {
    if (!tile.value->text().isEmpty()) words << tile.caption->text() + " " + tile.value->text();
  }
  return words.join(", ");
}

// Numbers that change keep their width, so that nothing beside them moves.
void Headline::set_sizes(double scale) {
  const int unit = static_cast<int>(scale * fontMetrics().height());
  row_->setContentsMargins(unit, unit / 3, unit, unit / 3);
  row_->setSpacing(static_cast<int>(kGap * unit));
  tiles_->setHorizontalSpacing(row_->spacing());
  set_size(*name_, font(), scale * kNameScale, true);
  name_->setMinimumWidth(std::min(kNameUnits * unit, name_->fontMetrics().horizontalAdvance(whole_name_)));
  for (const Tile& tile : {time_, phase_, mouth_, force_, capture_}) {
    set_size(*tile.caption, font(), scale * kCaptionScale, false);
    set_size(*tile.value, font(), scale * kValueScale, true);
    tile.value->setMinimumWidth(tile.value->fontMetrics().horizontalAdvance(tile.widest));
  }
}

void Headline::fit() {
  for (double scale = 1; scale > kSmallest; scale -= 0.05) {
    set_sizes(scale);
    row_->activate();
    if (row_->minimumSize().width() <= width()) break;
  }
  name_->setText(name_->fontMetrics().elidedText(whole_name_, Qt::ElideRight, name_->width()));
}

QSize Headline::minimumSizeHint() const { return {0, QWidget::minimumSizeHint().height()}; }

void Headline::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void Headline::follow_palette() {
  set_colour(*name_, palette().color(QPalette::Text));
  for (const Tile& tile : {time_, phase_, mouth_, force_, capture_}) {
    set_colour(*tile.caption, tone_colour(Tone::muted, palette()));
    set_colour(*tile.value, palette().color(QPalette::Text));
  }
  if (!capture_.value->text().isEmpty()) show_capture();
}

void Headline::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
  if (event->type() == QEvent::PaletteChange) follow_palette();
}

void Headline::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(0, height() - 1, width(), height() - 1);
}

}  // namespace netpocket
