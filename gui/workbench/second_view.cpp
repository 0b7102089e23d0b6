#include "gui/workbench/second_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/workbench/viewport/camera_names.h"

namespace netpocket {
namespace {

constexpr RunId kSameRun = -1;

}  // namespace

SecondView::SecondView(CaptureSession& session, Viewport& first, PresenterKind presenter, QWidget* parent)
    : QWidget(parent),
      session_(session),
      first_(first),
      viewport_(new Viewport(presenter)),
      runs_(new QComboBox),
      cameras_(new QComboBox),
      link_(new QToolButton) {
  viewport_->setAccessibleName(tr("Second view"));
  runs_->setAccessibleName(tr("Run of the second view"));
  runs_->setToolTip(tr("Which run the second view shows, at the same time as the first"));
  runs_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  runs_->setMinimumContentsLength(10);
  for (const CameraPreset preset : kCameraPresets) cameras_->addItem(camera_name(preset));
  cameras_->setAccessibleName(tr("Camera of the second view"));
  cameras_->setToolTip(tr("Where from"));
  link_->setText(tr("Link"));
  link_->setCheckable(true);
  link_->setToolTip(tr("Look at both views from the same place"));
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(6, 3, 6, 3);
  bar->addWidget(runs_, 1);
  bar->addWidget(cameras_);
  bar->addWidget(link_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(bar);
  layout->addWidget(viewport_, 1);

  connect(runs_, &QComboBox::currentIndexChanged, this, &SecondView::run_chosen);
  connect(cameras_, &QComboBox::activated, this, [this](int index) {
    link_->setChecked(false);
    viewport_->set_follow_target(false);
    viewport_->set_preset(kCameraPresets[static_cast<std::size_t>(index)]);
  });
  connect(link_, &QToolButton::toggled, this, &SecondView::link_cameras);
  connect(&first_, &Viewport::view_changed, this, [this] { copy_camera(first_, *viewport_); });
  connect(viewport_, &Viewport::view_changed, this, [this] { copy_camera(*viewport_, first_); });
  connect(viewport_, &Viewport::plot_requested, this, [this](const Pick& pick) { emit plot_requested(run(), pick); });
  connect(&session_.runs(), &RunLibrary::run_added, this, &SecondView::list_runs);
  connect(&session_.runs(), &RunLibrary::run_removed, this, &SecondView::list_runs);
  connect(&session_.runs(), &RunLibrary::run_changed, this, &SecondView::list_runs);
  connect(&session_.runs(), &RunLibrary::frame_loaded, this, &SecondView::frame_loaded);
  list_runs();
}

void SecondView::list_runs() {
  const RunId chosen = runs_->count() > 0 ? runs_->currentData().toInt() : kSameRun;
  {
    const QSignalBlocker quiet(runs_);
    runs_->clear();
    runs_->addItem(tr("Same run"), kSameRun);
    for (const RunId id : session_.runs().ids()) runs_->addItem(session_.runs().find(id)->name, id);
    runs_->setCurrentIndex(std::max(0, runs_->findData(chosen)));
  }
  if (runs_->currentData().toInt() != chosen) run_chosen();
}

void SecondView::run_chosen() {
  apply_options();
  refresh();
}

RunId SecondView::run() const {
  const RunId chosen = runs_->currentData().toInt();
  if (chosen != kSameRun) return chosen;
  return session_.current() ? session_.current()->id : -1;
}

void SecondView::choose_run(RunId id) { runs_->setCurrentIndex(std::max(0, runs_->findData(id))); }

void SecondView::link_cameras(bool linked) {
  link_->setChecked(linked);
  if (linked) copy_camera(first_, *viewport_);
}

void SecondView::copy_camera(Viewport& from, Viewport& to) {
  if (!link_->isChecked() || copying_ || !isVisible()) return;
  copying_ = true;
  to.set_view(from.view());
  copying_ = false;
}

void SecondView::set_options(const SceneOptions& options) {
  options_ = options;
  apply_options();
}

void SecondView::apply_options() {
  if (!isVisible()) return;
  SceneOptions options = options_;
  if (const Run* run = session_.runs().find(runs_->currentData().toInt())) options.phases = run->series.phases;
  viewport_->set_options(options);
  refresh();
}

void SecondView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  apply_options();
  refresh();
}

void SecondView::refresh() {
  if (!isVisible()) return;
  const RunId chosen = runs_->currentData().toInt();
  const Run* run = session_.runs().find(chosen);
  if (chosen == kSameRun || !first_.state().snapshot) {
    viewport_->set_pocket(first_.state().structure, first_.state().snapshot);
    viewport_->set_history(first_.state().history);
  } else if (run && run->frame_count() > 0) {
    wanted_ = run->frame_at(first_.state().snapshot->time);
    if (const auto frame = session_.runs().frame(chosen, wanted_)) show_frame(*run, frame);
  }
}

void SecondView::frame_loaded(RunId id, std::size_t index) {
  if (!isVisible() || id != runs_->currentData().toInt() || index != wanted_) return;
  const Run* run = session_.runs().find(id);
  if (const auto frame = session_.runs().frame(id, index)) show_frame(*run, frame);
}

void SecondView::show_frame(const Run& run, std::shared_ptr<const Snapshot> frame) {
  viewport_->set_pocket(run.structure, std::move(frame));
  viewport_->set_history(history_.of(run, options_));
}

}  // namespace netpocket
