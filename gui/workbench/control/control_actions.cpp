#include "gui/workbench/control/control_actions.h"

#include <QAction>
#include <QMenu>
#include <QPushButton>
#include <algorithm>

#include "engine/scenario/check_scenario.h"
#include "gui/workbench/control/control_panel.h"
#include "gui/workbench/control/disturbance_form.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

bool is_off(const ControllerParameters& controller) { return controller.phase == ControlPhase::off; }

}  // namespace

Scenario without_controllers(const Scenario& scenario) {
  Scenario without = scenario;
  for (ControllerParameters& controller : without.controllers) controller.phase = ControlPhase::off;
  return without;
}

ControlActions::ControlActions(CaptureSession& session, ControlPanel& panel, QWidget* window)
    : QObject(window),
      session_(session),
      panel_(panel),
      disturb_(new QAction(tr("Disturb"), this)),
      compare_(new QAction(tr("Compare without controllers"), this)) {
  disturb_->setShortcut(Qt::CTRL | Qt::Key_D);
  compare_->setShortcut(Qt::CTRL | Qt::Key_L);
  connect(disturb_, &QAction::triggered, this, &ControlActions::disturb);
  connect(panel_.disturbances(), &DisturbanceForm::wanted, this, &ControlActions::disturb);
  connect(compare_, &QAction::triggered, this, &ControlActions::compare);
  connect(panel_.compare_button(), &QPushButton::clicked, this, &ControlActions::compare);
  connect(&session_, &CaptureSession::current_changed, this, &ControlActions::refresh);
  connect(&session_.runs(), &RunLibrary::run_changed, this, &ControlActions::refresh);
  connect(&session_.runs(), &RunLibrary::frames_added, this, &ControlActions::refresh);
  refresh();
}

void ControlActions::fill(QMenu& menu) {
  menu.addSeparator();
  menu.addActions({disturb_, compare_});
}

void ControlActions::disturb() {
  if (!disturb_->isEnabled()) return;
  const DisturbanceParameters disturbance = panel_.disturbances()->disturbance();
  if (disturbance.force == Eigen::Vector3d::Zero() && disturbance.torque == Eigen::Vector3d::Zero()) {
    emit problem(tr("A disturbance needs a size other than 0."));
    return;
  }
  session_.disturb(disturbance);
}

// The same run with the controllers off, as far as this one has come.
void ControlActions::compare() {
  const Run* run = session_.current();
  if (run == nullptr || !compare_->isEnabled()) return;
  Scenario without = without_controllers(run->scenario);
  const RunId id = run->id;
  const double until = run->end_time();
  const QString suffix = tr(", with loop");
  QString name = run->name;
  if (name.endsWith(suffix)) name.chop(suffix.size());
  without.name = tr("%1, without loop").arg(name).toStdString();
  if (const Diagnostics problems = check_scenario(without); !problems.ok()) {
    emit problem(diagnostics_words(problems));
    return;
  }
  session_.runs().rename(id, name + suffix);
  session_.start(without, false);
  session_.resume({.until = until});
  emit comparison_begun(id);
}

void ControlActions::refresh() {
  const Run* live = session_.live();
  const bool goes_on = live != nullptr && live->can_go_on() && live->state != RunState::preparing;
  const bool takes_it = goes_on && find_parameter_list("disturbance", live->scenario.system) != nullptr;
  disturb_->setEnabled(takes_it);
  const QString disturb_help = takes_it  ? tr("Disturb the running simulation as the control panel says")
                               : goes_on ? tr("This kind of capture system has no disturbances")
                                         : tr("Only a run that goes on or is paused can be disturbed");
  disturb_->setToolTip(QString("%1 (%2)").arg(disturb_help, disturb_->shortcut().toString(QKeySequence::NativeText)));
  disturb_->setStatusTip(disturb_help);
  panel_.disturbances()->set_possible(takes_it, disturb_help);

  const Run* run = session_.current();
  const bool has_frames = run != nullptr && run->frame_count() > 1;
  const bool controlled =
      has_frames && !run->scenario.controllers.empty() && !std::ranges::all_of(run->scenario.controllers, is_off);
  const bool ready = controlled && !session_.is_running();
  compare_->setEnabled(ready);
  const QString help = ready        ? tr("Simulate the shown run once more with its controllers off, as far as it has "
                                                "come, and draw both in the plots")
                       : controlled ? tr("Pause the run first: the other one takes its place")
                                    : tr("Needs a run with controllers that are not off");
  compare_->setToolTip(QString("%1 (%2)").arg(help, compare_->shortcut().toString(QKeySequence::NativeText)));
  compare_->setStatusTip(help);
  panel_.compare_button()->setEnabled(ready);
  panel_.compare_button()->setToolTip(compare_->toolTip());
}

}  // namespace netpocket
