#include "gui/workbench/timeline/timeline_bar.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {
namespace {

constexpr std::array kSpeeds = {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0};
constexpr int kNormalSpeed = 4;      // index of 1
constexpr int kMarksInterval = 250;  // ms
constexpr int kLeastIcon = 16;       // pixels

}  // namespace

TimelineBar::TimelineBar(CaptureSession& session, QWidget* parent)
    : QWidget(parent), session_(session), strip_(new TimelineStrip), time_(new QLabel), speed_(new QComboBox) {
  make_actions();
  make_layout();
  marks_timer_.setSingleShot(true);
  marks_timer_.setInterval(kMarksInterval);
  connect(&marks_timer_, &QTimer::timeout, this, &TimelineBar::refresh_marks);
  connect(strip_, &TimelineStrip::time_chosen, this, &TimelineBar::go_to);
  connect(strip_, &TimelineStrip::step_requested, this, &TimelineBar::step_frames);
  connect(&playback_, &Playback::time_reached, this, [this](double time) { session_.show_time(time); });
  connect(&playback_, &Playback::playing_changed, this, &TimelineBar::refresh_buttons);
  connect(&session_, &CaptureSession::current_changed, this, [this] {
    playback_.stop();
    refresh_run();
    refresh_marks();
  });
  connect(&session_, &CaptureSession::frame_shown, this, &TimelineBar::refresh_time);
  connect(&session_.runs(), &RunLibrary::frames_added, this, &TimelineBar::refresh_run);
  connect(&session_.runs(), &RunLibrary::run_changed, this, &TimelineBar::refresh_run);
  refresh_run();
  refresh_time();
}

QAction* TimelineBar::add_action(ActionIcon icon, const QString& text, const QKeySequence& key, const QString& help) {
  auto* action = new QAction(action_icon(icon), text, this);
  action->setShortcut(key);
  action->setToolTip(QString("%1 (%2)").arg(help, key.toString(QKeySequence::NativeText)));
  action->setStatusTip(help);
  actions_ << action;
  return action;
}

void TimelineBar::make_actions() {
  first_ = add_action(ActionIcon::first, tr("To the start"), Qt::CTRL | Qt::Key_Home, tr("Go to the first frame"));
  back_ = add_action(ActionIcon::play_back, tr("Play backwards"), Qt::SHIFT | Qt::Key_P, tr("Play backwards"));
  step_back_ = add_action(ActionIcon::previous_frame, tr("Previous frame"), Qt::Key_Comma, tr("One frame back"));
  play_ = add_action(ActionIcon::play, tr("Play"), Qt::Key_P, tr("Play what is recorded"));
  step_ = add_action(ActionIcon::next_frame, tr("Next frame"), Qt::Key_Period, tr("One frame on"));
  last_ = add_action(ActionIcon::last, tr("To the end"), Qt::CTRL | Qt::Key_End,
                     tr("Go to the last frame and follow the run"));
  loop_ = add_action(ActionIcon::loop, tr("Loop"), Qt::Key_L, tr("Start over when the end is reached"));
  loop_->setCheckable(true);
  auto* mark = add_action(ActionIcon::mark, tr("Add marker"), Qt::Key_M, tr("Mark this time"));
  auto* unmark =
      add_action(ActionIcon::mark, tr("Remove marker"), Qt::SHIFT | Qt::Key_M, tr("Remove the own marker here"));
  auto* next_mark = add_action(ActionIcon::next_frame, tr("Next marker"), Qt::Key_N, tr("Go to the next marker"));
  auto* last_mark = add_action(ActionIcon::previous_frame, tr("Previous marker"), Qt::SHIFT | Qt::Key_N,
                               tr("Go to the previous marker"));
  connect(first_, &QAction::triggered, this, [this] { go_to(0); });
  connect(last_, &QAction::triggered, this, [this] {
    playback_.stop();
    session_.set_follow(true);
  });
  connect(back_, &QAction::triggered, this, [this] { play(-1); });
  connect(play_, &QAction::triggered, this, [this] { play(1); });
  connect(step_back_, &QAction::triggered, this, [this] { step_frames(-1); });
  connect(step_, &QAction::triggered, this, [this] { step_frames(1); });
  connect(loop_, &QAction::toggled, &playback_, &Playback::set_loop);
  connect(mark, &QAction::triggered, this, &TimelineBar::add_mark);
  connect(unmark, &QAction::triggered, this, &TimelineBar::remove_mark);
  connect(next_mark, &QAction::triggered, this, [this] { go_to_mark(1); });
  connect(last_mark, &QAction::triggered, this, [this] { go_to_mark(-1); });
}

void TimelineBar::make_layout() {
  auto* layout = new QHBoxLayout;
  layout->setContentsMargins(6, 0, 12, 0);
  layout->setSpacing(2);
  for (QAction* action : {first_, back_, step_back_, play_, step_, last_, loop_}) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action->text());
    layout->addWidget(button);
  }
  for (const double speed : kSpeeds) speed_->addItem(QString::fromUtf8("× %1").arg(speed), speed);
  speed_->setCurrentIndex(kNormalSpeed);
  speed_->setToolTip(tr("Speed of playing, against real time"));
  speed_->setAccessibleName(tr("Speed of playing"));
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this] { playback_.set_speed(speed_->currentData().toDouble()); });
  layout->addSpacing(8);
  layout->addWidget(speed_);
  layout->addStretch(1);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_->setMinimumWidth(fontMetrics().horizontalAdvance("000.000 / 000.00 s") + 8);
  time_->setToolTip(tr("Time shown, and end of what is recorded"));
  layout->addWidget(time_);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 2, 0, 4);
  rows->setSpacing(0);
  rows->addWidget(strip_);
  rows->addLayout(layout);
}

// Symbols as large as letters.
void TimelineBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  const int side = std::max(kLeastIcon, fontMetrics().height() + 1);
  for (auto* button : findChildren<QToolButton*>()) button->setIconSize({side, side});
}

void TimelineBar::go_to(double time) {
  playback_.stop();
  const Run* run = session_.current();
  // At the end of a run that grows, its new frames are followed.
  session_.set_follow(run != nullptr && time >= run->end_time() && session_.is_running());
  session_.show_time(time);
}

void TimelineBar::step_frames(int frames) {
  const Run* run = session_.current();
  if (run == nullptr || run->frame_count() == 0) return;
  playback_.stop();
  session_.set_follow(false);
  const auto last = static_cast<std::ptrdiff_t>(run->frame_count()) - 1;
  const auto index = static_cast<std::ptrdiff_t>(session_.shown_index()) + frames;
  session_.show_frame(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last)));
}

void TimelineBar::go_to_mark(int direction) {
  constexpr double kHere = 1e-6;  // s
  const auto& marks = strip_->marks();
  const double time = strip_->time();
  if (direction > 0) {
    const auto next = std::find_if(marks.begin(), marks.end(), [&](const auto& m) { return m.time > time + kHere; });
    if (next != marks.end()) go_to(next->time);
  } else {
    const auto next = std::find_if(marks.rbegin(), marks.rend(), [&](const auto& m) { return m.time < time - kHere; });
    if (next != marks.rend()) go_to(next->time);
  }
}

void TimelineBar::add_mark() {
  const Run* run = session_.current();
  if (run == nullptr || run->frame_count() == 0) return;
  session_.runs().add_note(run->id, {TimeMark::Kind::own, strip_->time(), tr("Marker")});
}

void TimelineBar::remove_mark() {
  if (const Run* run = session_.current()) session_.runs().remove_note(run->id, strip_->time());
}

void TimelineBar::play(int direction) {
  if (playback_.is_playing() && playback_.direction() == direction) {
    playback_.stop();
    return;
  }
  session_.set_follow(false);
  playback_.set_time(strip_->time());
  playback_.play(direction);
}

void TimelineBar::refresh_run() {
  const Run* run = session_.current();
  const double end = run ? run->end_time() : 0;
  strip_->set_extent(end, run && run->state != RunState::recorded ? run->scenario.output.end_time : end);
  playback_.set_range(0, end);
  const bool any = run != nullptr && run->frame_count() > 0;
  for (QAction* action : {first_, back_, step_back_, play_, step_, last_}) action->setEnabled(any);
  strip_->setEnabled(any);
  refresh_time();
  if (!marks_timer_.isActive()) marks_timer_.start();
}

void TimelineBar::refresh_marks() {
  const Run* run = session_.current();
  strip_->set_marks(run ? time_marks(*run) : std::vector<TimeMark>());
}

void TimelineBar::refresh_time() {
  const Run* run = session_.current();
  if (run == nullptr || run->frame_count() == 0) {
    strip_->set_time(0);
    time_->setText(QString::fromUtf8("– / – s"));
    return;
  }
  const double time = run->series.times()[std::min(session_.shown_index(), run->frame_count() - 1)];
  strip_->set_time(time);
  time_->setText(tr("%1 / %2 s").arg(time, 0, 'f', 3).arg(run->end_time(), 0, 'f', 2));
}

void TimelineBar::refresh_buttons() {
  const bool playing = playback_.is_playing();
  play_->setIcon(action_icon(playing && playback_.direction() > 0 ? ActionIcon::pause : ActionIcon::play));
  back_->setIcon(action_icon(playing && playback_.direction() < 0 ? ActionIcon::pause : ActionIcon::play_back));
}

}  // namespace netpocket
