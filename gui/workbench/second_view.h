#pragma once
// Another viewport beside the first: the same run from elsewhere, or another run at the same time.
// Thread contract: the user interface's thread.

#include <QWidget>

#include "gui/workbench/session/capture_session.h"
#include "gui/workbench/view_history.h"
#include "gui/workbench/viewport/viewport.h"

class QComboBox;
class QToolButton;

namespace netpocket {

class SecondView : public QWidget {
  Q_OBJECT
 public:
  // The session and the first viewport must outlive it.
  SecondView(CaptureSession& session, Viewport& first, PresenterKind presenter, QWidget* parent = nullptr);

  Viewport& viewport() { return *viewport_; }
  // The run that is shown here; -1: none. By default the one of the first view.
  RunId run() const;
  // Shows another run, or with -1 always that of the first view.
  void choose_run(RunId id);
  // Whether both views are looked at from the same place.
  void link_cameras(bool linked);

  void set_options(const SceneOptions& options);
  // What the first view shows has changed.
  void refresh();

 signals:
  void plot_requested(netpocket::RunId run, const netpocket::Pick& pick);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void list_runs();
  void run_chosen();
  void apply_options();
  void show_frame(const Run& run, std::shared_ptr<const Snapshot> frame);
  void frame_loaded(RunId run, std::size_t index);
  void copy_camera(Viewport& from, Viewport& to);

  CaptureSession& session_;
  Viewport& first_;
  Viewport* viewport_;
  QComboBox* runs_;
  QComboBox* cameras_;
  QToolButton* link_;
  SceneOptions options_;
  ViewHistory history_;
  std::size_t wanted_ = 0;  // frame of a run that is being read
  bool copying_ = false;
};

}  // namespace netpocket
