#pragma once
// Running, pausing, stepping, branching: the commands that act on the simulation.

#include <QObject>
#include <functional>

#include "gui/workbench/session/capture_session.h"

class QAction;
class QComboBox;
class QMenu;
class QToolBar;
class QWidget;

namespace netpocket {

class RunActions : public QObject {
  Q_OBJECT
 public:
  // `scenario` gives the scenario to simulate, or nothing when it has an error (which is shown then).
  RunActions(CaptureSession& session, std::function<std::optional<Scenario>()> scenario, QWidget* window);

  void fill(QMenu& menu, QToolBar& bar);
  QAction* run_action() const { return run_; }

  // Runs on from where the live run is; without one, starts the scenario.
  void run_or_pause();
  void restart();
  void branch();

 private:
  enum class Goal { contact, closing_end, tow_start };

  QAction* add(const QString& text, const QKeySequence& key, const QString& help);
  void run_to(const Resume& goal);
  void run_to(Goal goal);
  void ask_for_time();
  void refresh();
  void make_pace_choice();

  CaptureSession& session_;
  std::function<std::optional<Scenario>()> scenario_;
  QWidget* window_;
  QAction *run_, *step_, *restart_, *branch_, *to_time_, *to_contact_, *to_closing_, *to_tow_;
  QComboBox* pace_;
};

}  // namespace netpocket
