#pragma once
// Shows a pocket and lets it be looked at from all sides.
//
// Left drag: orbit; with Shift, or middle drag: pan; with Ctrl: roll; right drag or wheel: zoom. Click: pick; double
// click: look at what is there. Arrow keys orbit, with Shift they pan; + and - zoom. While bodies are moved: left drag
// of the target or the spacecraft moves it, with Shift along one axis.
//
// While anything changes, pictures are drafts; the last one is drawn again, smoothed, when nothing has changed for a
// moment.

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "gui/workbench/viewport/body_drag.h"
#include "gui/workbench/viewport/orbit_camera.h"
#include "gui/workbench/viewport/picker.h"
#include "gui/workbench/viewport/presenter.h"

namespace netpocket {

class PickPanel;
class ViewportOverlay;

class Viewport : public QWidget {
  Q_OBJECT
 public:
  explicit Viewport(PresenterKind kind, QWidget* parent = nullptr);
  ~Viewport() override;

  // Shows a pocket; the camera stays where it is. Null: nothing.
  void set_pocket(std::shared_ptr<const Structure> structure, std::shared_ptr<const Snapshot> snapshot);
  // Another state of the same pocket.
  void set_snapshot(std::shared_ptr<const Snapshot> snapshot);
  const ViewState& state() const { return state_; }
  // What the picture on the screen is of, and clicks pick from: state(), or one shortly before.
  const ViewState& shown() const { return shown_; }

  // Of the run that is shown, for trails and the initial shape; null: none.
  void set_history(std::shared_ptr<const SceneHistory> history);

  void set_options(const SceneOptions& options);
  const SceneOptions& options() const { return *state_.options; }

  // Frames what is visible now from a preset's direction, or keeping the present one.
  void set_preset(CameraPreset preset);
  // The preset from whose direction one looks; none when the camera has been turned since.
  std::optional<CameraPreset> preset() const { return looks_from_preset_ ? std::optional(preset_) : std::nullopt; }
  void fit();
  void set_view(const CameraView& view);
  const CameraView& view() const { return state_.camera; }
  // The camera moves with the target.
  void set_follow_target(bool follow);

  void set_measuring(bool measuring);
  bool is_measuring() const { return measuring_; }
  // Whether a left drag moves the body under the mouse. The picture follows at once; what else a move means is for
  // those to do who listen to body_dragged().
  void set_moving(bool moving);
  void select(const std::optional<Pick>& pick);
  const std::optional<Pick>& selection() const { return selection_; }
  const std::vector<Pick>& measured() const { return measured_; }

  // In the middle of the viewport, when there is nothing else to see.
  void set_message(const QString& message);
  // In small letters on top; for what is shown.
  void set_hint(const QString& hint);
  QImage picture() { return presenter_->picture(); }
  QString presenter_description() const { return presenter_->description(); }

  QSize sizeHint() const override { return {800, 560}; }
  QSize minimumSizeHint() const override { return {240, 180}; }

 signals:
  void picked(const std::optional<netpocket::Pick>& pick);
  void plot_requested(const netpocket::Pick& pick);
  void view_changed();
  void picture_shown(double time, double seconds);  // s: simulated; taken to draw
  void body_drag_started();
  void body_dragged(netpocket::BodyRole role, const Eigen::Vector3d& position);  // m, centre of mass
  void body_drag_ended();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Drag { none, orbit, pan, roll, zoom, body };

  void refresh();
  void refine();
  void picture_came(const ViewState& shown, double seconds);
  void update_overlay(const ViewState& shown);
  void set_camera(const OrbitCamera& camera);
  void aim(const OrbitCamera& camera);
  void drag_to(const QPointF& position);
  bool grab_body(const QPointF& position);
  void drag_body_to(const QPointF& position, bool along_one_axis);
  void show_cursor();
  void end_drag();
  void click(const QPointF& position);
  Eigen::Vector3d target_position(const Snapshot& snapshot) const;
  void place_panel();
  double aspect() const;
  void keep_in_sight(const QSize& before);

  std::unique_ptr<Presenter> presenter_;
  ViewportOverlay* overlay_;
  PickPanel* panel_;
  ViewState state_;
  ViewState shown_;
  QTimer rest_;  // runs out when nothing has changed for a moment
  CameraPreset preset_ = CameraPreset::iso;
  bool looks_from_preset_ = true;
  bool framed_ = false;      // whether the camera has been aimed at a pocket
  double aimed_aspect_ = 1;  // of the picture when the camera was set last
  bool follow_ = false;
  bool measuring_ = false;
  bool moving_ = false;
  std::optional<Pick> selection_;
  std::vector<Pick> measured_;
  Drag drag_ = Drag::none;
  std::optional<BodyDrag> body_drag_;
  std::size_t dragged_body_ = 0;
  Eigen::Vector3d dragged_to_{0, 0, 0};  // m, world
  bool moved_ = false;                   // since the button went down
  QPointF pressed_at_;
  QPointF last_;
};

}  // namespace netpocket
