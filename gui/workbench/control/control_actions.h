#pragma once
// What acts on the control of a run: a disturbance now, and the comparison with a run without the controllers.

#include <QObject>

#include "gui/workbench/session/capture_session.h"

class QAction;
class QMenu;
class QWidget;

namespace netpocket {

class ControlPanel;

class ControlActions : public QObject {
  Q_OBJECT
 public:
  ControlActions(CaptureSession& session, ControlPanel& panel, QWidget* window);

  void fill(QMenu& menu);
  QAction* disturb_action() const { return disturb_; }
  QAction* compare_action() const { return compare_; }

 signals:
  // Another run has begun beside this one, to be drawn over it.
  void comparison_begun(netpocket::RunId with_loop);
  void problem(const QString& text);

 private:
  void disturb();
  void compare();
  void refresh();

  CaptureSession& session_;
  ControlPanel& panel_;
  QAction *disturb_, *compare_;
};

// A scenario with all its controllers off.
Scenario without_controllers(const Scenario& scenario);

}  // namespace netpocket
