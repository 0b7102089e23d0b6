#include "gui/workbench/run_actions.h"

#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QMenu>
#include <QToolBar>
#include <cmath>

#include "engine/systems/capture_system.h"
#include "gui/workbench/action_icons.h"

namespace netpocket {

RunActions::RunActions(CaptureSession& session, std::function<std::optional<Scenario>()> scenario, QWidget* window)
    : QObject(window), session_(session), scenario_(std::move(scenario)), window_(window), pace_(new QComboBox) {
  run_ = add(tr("Run"), Qt::Key_Space, tr("Run or pause the simulation"));
  step_ = add(tr("Single step"), Qt::CTRL | Qt::Key_Period, tr("Simulate one integration step"));
  restart_ = add(tr("Restart"), Qt::CTRL | Qt::Key_R, tr("Simulate the scenario anew from the start"));
  branch_ = add(tr("Branch here"), Qt::CTRL | Qt::Key_B,
                tr("Run on from the shown frame as a second run, with the strategy as edited"));
  to_time_ = add(tr("Run to time…"), Qt::CTRL | Qt::Key_T, tr("Run to a simulated time"));
  to_contact_ = add(tr("Run to next contact"), Qt::CTRL | Qt::Key_1, tr("Run until the target is touched"));
  to_closing_ = add(tr("Run to end of closing"), Qt::CTRL | Qt::Key_2, tr("Run until the mouth is closed"));
  to_tow_ = add(tr("Run to start of towing"), Qt::CTRL | Qt::Key_3, tr("Run until towing starts"));
  step_->setIcon(action_icon(ActionIcon::step));
  restart_->setIcon(action_icon(ActionIcon::restart));
  branch_->setIcon(action_icon(ActionIcon::branch));
  connect(run_, &QAction::triggered, this, &RunActions::run_or_pause);
  connect(step_, &QAction::triggered, &session_, &CaptureSession::single_step);
  connect(restart_, &QAction::triggered, this, &RunActions::restart);
  connect(branch_, &QAction::triggered, this, &RunActions::branch);
  connect(to_time_, &QAction::triggered, this, &RunActions::ask_for_time);
  connect(to_contact_, &QAction::triggered, this, [this] { run_to(Goal::contact); });
  connect(to_closing_, &QAction::triggered, this, [this] { run_to(Goal::closing_end); });
  connect(to_tow_, &QAction::triggered, this, [this] { run_to(Goal::tow_start); });
  connect(&session_, &CaptureSession::current_changed, this, &RunActions::refresh);
  connect(&session_.runs(), &RunLibrary::run_changed, this, &RunActions::refresh);
  make_pace_choice();
  refresh();
}

QAction* RunActions::add(const QString& text, const QKeySequence& key, const QString& help) {
  auto* action = new QAction(text, this);
  action->setShortcut(key);
  action->setToolTip(QString("%1 (%2)").arg(help, key.toString(QKeySequence::NativeText)));
  action->setStatusTip(help);
  return action;
}

void RunActions::make_pace_choice() {
  pace_->addItem(tr("As fast as possible"), 0.0);
  pace_->addItem(tr("Real time"), 1.0);
  pace_->addItem(tr("Slow motion, 1/5"), 0.2);
  pace_->addItem(tr("Slow motion, 1/20"), 0.05);
  pace_->setToolTip(tr("How fast the simulation may go"));
  pace_->setAccessibleName(tr("Pace of the simulation"));
  connect(pace_, &QComboBox::currentIndexChanged, this, [this] { session_.set_pace(pace_->currentData().toDouble()); });
}

void RunActions::fill(QMenu& menu, QToolBar& bar) {
  menu.addActions({run_, step_, restart_, branch_});
  menu.addSeparator();
  menu.addActions({to_time_, to_contact_, to_closing_, to_tow_});
  bar.addActions({run_, step_, restart_, branch_});
  bar.addWidget(pace_);
}

void RunActions::run_or_pause() {
  if (session_.is_running()) {
    session_.pause();
  } else {
    run_to(Resume{});
  }
}

void RunActions::restart() {
  if (const auto scenario = scenario_()) session_.start(*scenario, true);
}

void RunActions::branch() {
  if (const auto scenario = scenario_()) session_.branch(*scenario);
}

void RunActions::run_to(const Resume& goal) {
  const Run* live = session_.live();
  if (live == nullptr || !live->can_go_on()) {
    const auto scenario = scenario_();
    if (!scenario) return;
    session_.start(*scenario, false);
  } else if (session_.current() != live) {
    session_.show_run(live->id);
  }
  session_.set_follow(true);
  session_.resume(goal);
}

void RunActions::run_to(Goal goal) {
  if (goal == Goal::contact) {
    run_to(Resume{.until_contact = true});
    return;
  }
  const Run* live = session_.live();
  const auto scenario = live ? std::optional(live->scenario) : scenario_();
  if (!scenario) return;
  const std::vector<Phase> phases = capture_phases(*scenario);
  const double time = goal == Goal::closing_end ? phase_end(phases, kClosing) : phase_begin(phases, kTowing);
  if (std::isfinite(time)) run_to(Resume{.until = time});
}

void RunActions::ask_for_time() {
  const Run* live = session_.live();
  constexpr double kLongest = 1e5;  // s
  bool accepted = false;
  const double from = live ? live->end_time() : 0;
  const double time = QInputDialog::getDouble(window_, tr("Run to time"), tr("Simulated time, s:"), from + 1, from,
                                              kLongest, 3, &accepted);
  if (accepted) run_to(Resume{.until = time});
}

void RunActions::refresh() {
  const bool running = session_.is_running();
  run_->setIcon(action_icon(running ? ActionIcon::pause : ActionIcon::run));
  run_->setText(running ? tr("Pause") : tr("Run"));
  const Run* current = session_.current();
  step_->setEnabled(session_.live() != nullptr && session_.live()->can_go_on());
  branch_->setEnabled(current != nullptr && current->continuable && current->frame_count() > 0);
}

}  // namespace netpocket
