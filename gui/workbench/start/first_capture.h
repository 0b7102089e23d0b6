#pragma once
// The guided first capture: a line of steps across the top of the view. A step is done when the state of the window
// says that the user has done it; then the next one follows. It can be left at any time and changes nothing by itself.
// Thread contract: the user interface's thread.

#include <QFrame>
#include <functional>
#include <vector>

#include "gui/workbench/editor/scenario_document.h"
#include "gui/workbench/session/capture_session.h"

class QLabel;
class QPushButton;

namespace netpocket {

class ExportTray;
class PlotsPanel;
class Viewport;

// The parts of the window whose state tells what has been done; all must outlive the guide.
struct GuidedParts {
  ScenarioDocument& document;
  CaptureSession& session;
  Viewport& viewport;
  PlotsPanel& plots;
  ExportTray& exports;
};

enum class GuideStep { look, change, run, scrub, force, picture, end };

class FirstCapture : public QFrame {
  Q_OBJECT
 public:
  explicit FirstCapture(const GuidedParts& parts, QWidget* parent = nullptr);

  // Shows the first step.
  void begin();
  void leave() { hide(); }
  GuideStep step() const { return step_; }
  QString text() const;
  QPushButton* show_button() const { return show_; }
  QPushButton* skip_button() const { return skip_; }
  QPushButton* leave_button() const { return leave_; }

 signals:
  // The user wants to see where the step is done.
  void place_wanted(netpocket::GuideStep step);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Start {  // of the present step
    Eigen::Vector3d direction{0, 0, 0};
    Scenario scenario;
    std::size_t frame = 0;
  };

  void make_layout();
  void watch();
  void check();
  bool is_done() const;
  bool has_run() const;
  bool has_turned() const;
  void go_to(GuideStep step);
  void show_step();
  void set_colours();

  GuidedParts parts_;
  GuideStep step_ = GuideStep::look;
  Start start_;
  bool exported_ = false;
  QLabel* title_;
  QLabel* text_;
  QLabel* trail_;
  QPushButton* show_;
  QPushButton* skip_;
  QPushButton* leave_;
};

}  // namespace netpocket
