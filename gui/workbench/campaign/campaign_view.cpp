#include "gui/workbench/campaign/campaign_view.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/workbench/campaign/capture_map_view.h"
#include "gui/workbench/campaign/point_words.h"
#include "gui/workbench/campaign/still_figure.h"
#include "gui/workbench/panels/engine_words.h"
#include "gui/workbench/panels/tones.h"
#include "render/figures/study_figures.h"

namespace netpocket {
namespace {

constexpr int kRedrawInterval = 300;    // ms, at least
constexpr qint64 kRestPerDrawing = 10;  // times as long as drawing took
constexpr int kRowsOfPoint = 10;        // lines of a point's values that are shown at once
constexpr int kColumnsOfDistributions = 2;
const QString kMap = QStringLiteral("map");

// Names that are too long lose their middle, not the panel its width.
QComboBox* make_named_choice(const QString& name, const QString& help) {
  auto* box = new QComboBox;
  box->setAccessibleName(name);
  box->setToolTip(help);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  return box;
}

QLabel* make_text() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  return label;
}

// Pixels, below which a picture is scrolled instead of being squeezed.
QSize least_size(const QString& picture, const Figure& figure, int inputs) {
  if (picture == "influence") return {300, 90 + 24 * inputs};
  if (picture == "parallel_coordinates") return {90 + 70 * inputs, 220};
  const int panels = static_cast<int>(figure.panels.size()), rows = (panels + figure.columns - 1) / figure.columns;
  return {150 * figure.columns, 135 * rows};
}

QString problems_words(const LiveResults& results) {
  QString text;
  if (results.refused() > 0) text += CampaignView::tr("; %1 refused as not valid").arg(results.refused());
  if (results.diverged() > 0) text += CampaignView::tr("; %1 diverged").arg(results.diverged());
  if (results.limited() > 0) text += CampaignView::tr("; %1 at their limit of steps").arg(results.limited());
  return text;
}

// What the panel shows of drafts says so, with their bias.
QString drafts_words(const LiveResults& results) {
  if (results.drafts() == 0) return {};
  const QString notice = engine_words(results.draft_notice()).toHtmlEscaped();
  return results.drafts() == results.results().size() ? CampaignView::tr("<b>Drafts</b>: %1").arg(notice)
                                                      : CampaignView::tr("<b>Some are drafts</b>: %1").arg(notice);
}

QString pace_words(const Campaign& campaign) {
  const double rate = campaign.captures_a_minute();
  if (!(rate > 0)) return {};
  QString text = CampaignView::tr(", %1 captures a minute").arg(QString::number(rate, 'f', rate < 10 ? 1 : 0));
  if (const auto left = campaign.time_left()) text += CampaignView::tr(", %1 left").arg(time_words(*left));
  return text;
}

}  // namespace

CampaignView::CampaignView(QWidget* parent) : QWidget(parent) {
  map_ = new CaptureMapView;
  figure_ = new StillFigure;
  stack_ = new QStackedWidget;
  stack_->addWidget(map_);
  figure_frame_ = new QScrollArea;
  figure_frame_->setWidget(figure_);
  figure_frame_->setWidgetResizable(true);
  figure_frame_->setFrameShape(QFrame::NoFrame);
  stack_->addWidget(figure_frame_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(make_head());
  layout->addWidget(make_chooser());
  layout->addWidget(stack_, 1);
  layout->addWidget(make_details());
  throttle_.setSingleShot(true);
  throttle_.setInterval(kRedrawInterval);
  connect(&throttle_, &QTimer::timeout, this, &CampaignView::refresh_results);
  connect(map_, &CaptureMapView::chosen_changed, this, &CampaignView::show_chosen);
  connect(map_, &CaptureMapView::open_requested, open_, &QPushButton::click);
  show_picture();
  show_chosen();
}

QWidget* CampaignView::make_head() {
  auto* head = new QWidget;
  name_ = make_text();
  state_ = make_text();
  estimate_ = make_text();
  drafts_ = make_text();
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(14);
  progress_->setAccessibleName(tr("Points done"));
  stop_ = new QPushButton;
  leave_ = new QPushButton(tr("Other campaign…"));
  leave_->setToolTip(tr("Define a campaign for the scenario, or open another one"));
  connect(leave_, &QPushButton::clicked, this, &CampaignView::leave_requested);
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (campaign_ == nullptr) return;
    if (campaign_->is_running()) {
      campaign_->stop();
    } else {
      campaign_->start(jobs_);
    }
  });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(stop_);
  buttons->addWidget(leave_);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(head);
  layout->setContentsMargins(8, 8, 8, 0);
  layout->setSpacing(4);
  layout->addWidget(name_);
  layout->addWidget(progress_);
  layout->addWidget(state_);
  layout->addWidget(estimate_);
  layout->addWidget(drafts_);
  layout->addLayout(buttons);
  return head;
}

QWidget* CampaignView::make_chooser() {
  auto* chooser = new QWidget;
  pictures_ = make_named_choice(tr("Picture"), tr("What to draw"));
  pictures_->addItem(tr("Map of the captures"), kMap);
  pictures_->addItem(tr("Convergence"), "convergence");
  pictures_->addItem(tr("What decides"), "influence");
  pictures_->addItem(tr("Distributions"), "distributions");
  pictures_->addItem(tr("Parallel coordinates"), "parallel_coordinates");
  x_axis_ = make_named_choice(tr("Input to the right"), tr("The input to the right"));
  y_axis_ = make_named_choice(tr("Input upwards"), tr("The input upwards"));
  axes_ = new QWidget;
  auto* axes = new QHBoxLayout(axes_);
  axes->setContentsMargins(0, 0, 0, 0);
  axes->addWidget(new QLabel("→"));
  axes->addWidget(x_axis_, 1);
  axes->addWidget(new QLabel("↑"));
  axes->addWidget(y_axis_, 1);
  auto* layout = new QVBoxLayout(chooser);
  layout->setContentsMargins(8, 4, 8, 0);
  layout->setSpacing(4);
  layout->addWidget(pictures_);
  layout->addWidget(axes_);
  connect(pictures_, &QComboBox::currentIndexChanged, this, &CampaignView::show_picture);
  for (QComboBox* box : {x_axis_, y_axis_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &CampaignView::take_axes);
  }
  return chooser;
}

QWidget* CampaignView::make_details() {
  details_ = new QFrame;
  point_ = make_text();
  point_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  open_ = new QPushButton(tr("Open this capture"));
  open_->setToolTip(tr("Run this capture in the window (Enter)"));
  adopt_ = new QPushButton(tr("Make it the scenario"));
  adopt_->setToolTip(tr("Put the values of this point into the editor; Undo takes that back"));
  connect(open_, &QPushButton::clicked, this, [this] {
    if (map_->chosen()) emit open_requested(*map_->chosen());
  });
  connect(adopt_, &QPushButton::clicked, this, [this] {
    if (map_->chosen()) emit adopt_requested(*map_->chosen());
  });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(open_);
  buttons->addWidget(adopt_);
  buttons->addStretch();
  // Many inputs must not take the map's room.
  auto* scroller = new QScrollArea;
  scroller->setWidget(point_);
  scroller->setWidgetResizable(true);
  scroller->setFrameShape(QFrame::NoFrame);
  scroller->setFixedHeight(kRowsOfPoint * fontMetrics().lineSpacing());
  point_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* layout = new QVBoxLayout(details_);
  layout->setContentsMargins(8, 0, 8, 8);
  layout->addWidget(scroller);
  layout->addLayout(buttons);
  return details_;
}

void CampaignView::set_campaign(Campaign* campaign) {
  if (campaign_ != nullptr) campaign_->disconnect(this);
  campaign_ = campaign;
  map_->set_results(nullptr);
  {
    const QSignalBlocker quiet_x(x_axis_), quiet_y(y_axis_);
    x_axis_->clear();
    y_axis_->clear();
  }
  if (campaign_ != nullptr) {
    connect(campaign_, &Campaign::changed, this, &CampaignView::refresh_results);
    connect(campaign_, &Campaign::points_came, this, [this] {
      if (!throttle_.isActive()) throttle_.start();
    });
  }
  refresh_state();
  refresh_results();
}

void CampaignView::refresh_state() {
  if (campaign_ == nullptr) return;
  const LiveResults* results = campaign_->results();
  const std::size_t points = campaign_->manifest() ? campaign_->manifest()->points : 0;
  const std::size_t done = results != nullptr ? results->finished() : 0;
  name_->setText(QString("<b>%1</b>").arg(campaign_->name().toHtmlEscaped()));
  name_->setToolTip(campaign_->folder());
  progress_->setRange(0, static_cast<int>(std::max<std::size_t>(points, 1)));
  progress_->setValue(static_cast<int>(campaign_->is_complete() ? points : std::min(done, points)));
  const QString count = points > 0 ? tr("%1 of %2 points").arg(done).arg(points) : tr("no point yet");
  const QString problems = results != nullptr ? problems_words(*results) : QString();
  QString state;
  if (campaign_->is_stopping()) {
    state = tr("Stopping: %1").arg(count);
  } else if (campaign_->is_running()) {
    state = tr("Running: %1").arg(count) + pace_words(*campaign_);
  } else if (campaign_->is_run_elsewhere()) {
    state = tr("Another program runs it: %1").arg(count) + pace_words(*campaign_);
  } else if (campaign_->is_complete()) {
    state = done < points ? tr("Ended early, as it was told to: %1").arg(count) : tr("Done: %1").arg(count);
  } else {
    state = tr("Not complete: %1").arg(count);
  }
  state_->setText(state + problems);
  state_->setToolTip(results != nullptr ? engine_words(results->first_refusal()) : QString());
  const bool can_go_on = !campaign_->study().isEmpty() && !campaign_->is_run_elsewhere();
  stop_->setText(campaign_->is_running() ? tr("Stop") : tr("Go on"));
  stop_->setEnabled(campaign_->is_running() ? !campaign_->is_stopping() : can_go_on && !campaign_->is_complete());
  stop_->setToolTip(campaign_->is_running()        ? tr("End it; points that are done are kept, and it can go on later")
                    : campaign_->study().isEmpty() ? tr("The study's file is not where it was when the folder was made")
                                                   : tr("Run the points that are missing"));
  leave_->setEnabled(!campaign_->is_running());
}

void CampaignView::refresh_results() {
  QElapsedTimer time;
  time.start();
  const LiveResults* results = campaign_ != nullptr ? campaign_->results() : nullptr;
  if (results != nullptr) {
    offer_axes();
    map_->set_results(&results->results());
    estimate_->setText(estimate_words(results->captured(), results->judged()));
  }
  estimate_->setVisible(results != nullptr);
  drafts_->setText(results != nullptr ? drafts_words(*results) : QString());
  drafts_->setVisible(!drafts_->text().isEmpty());
  show_picture();
  refresh_state();
  if (stack_->currentWidget() == figure_frame_) figure_->repaint();
  throttle_.setInterval(static_cast<int>(std::max<qint64>(kRedrawInterval, kRestPerDrawing * time.elapsed())));
}

// The inputs that decide most if that can be told already, else the first ones. What was chosen stays.
void CampaignView::offer_axes() {
  const StudyResults& results = campaign_->results()->results();
  if (x_axis_->count() == static_cast<int>(results.inputs.size())) return;
  const QString x = x_axis_->currentText(), y = y_axis_->currentText();
  const QSignalBlocker quiet_x(x_axis_), quiet_y(y_axis_);
  for (QComboBox* box : {x_axis_, y_axis_}) {
    box->clear();
    for (const ResultColumn& input : results.inputs) box->addItem(QString::fromStdString(input.name));
  }
  std::vector<std::size_t> order;
  for (const InputInfluence& influence : input_influences(results)) order.push_back(influence.input);
  constexpr std::size_t kFewestToJudge = 100;
  if (order.size() < 2 || results.size() < kFewestToJudge) order = {0, 1};
  const auto choose = [](QComboBox* box, const QString& before, std::size_t otherwise) {
    const int known = before.isEmpty() ? -1 : box->findText(before);
    box->setCurrentIndex(known >= 0 ? known : std::min(static_cast<int>(otherwise), box->count() - 1));
  };
  choose(x_axis_, x, order[0]);
  choose(y_axis_, y, order[1]);
  take_axes();
}

void CampaignView::take_axes() {
  map_->set_axes(x_axis_->currentText().toStdString(), y_axis_->currentText().toStdString());
}

void CampaignView::show_picture() {
  const QString picture = pictures_->currentData().toString();
  const bool is_map = picture == kMap;
  axes_->setVisible(is_map);
  stack_->setCurrentWidget(is_map ? static_cast<QWidget*>(map_) : figure_frame_);
  show_chosen();
  const LiveResults* results = campaign_ != nullptr ? campaign_->results() : nullptr;
  if (is_map || results == nullptr) return;
  Figure figure = make_study_figure(picture.toStdString(), results->results());
  const int inputs = static_cast<int>(results->results().inputs.size());
  if (picture == "distributions") figure.columns = kColumnsOfDistributions;
  const QSize least = least_size(picture, figure, inputs);
  figure_->set_figure(std::move(figure), least);
}

void CampaignView::show_chosen() {
  const auto row = map_->chosen();
  const LiveResults* results = campaign_ != nullptr ? campaign_->results() : nullptr;
  const bool shown = row && results != nullptr && stack_->currentWidget() == map_;
  details_->setVisible(shown);
  if (shown) point_->setText(point_words(results->results(), *row));
}

QString CampaignView::state_text() const { return state_->text(); }
QString CampaignView::estimate_text() const { return estimate_->text(); }
QString CampaignView::draft_text() const { return drafts_->text(); }
QString CampaignView::point_text() const { return point_->text(); }

void CampaignView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) figure_->update();
}

}  // namespace netpocket
