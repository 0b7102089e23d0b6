#include "gui/workbench/viewport/viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <cmath>
#include <numbers>
#include <utility>

#include "gui/workbench/panels/focus_frame.h"
#include "gui/workbench/viewport/pick_panel.h"
#include "gui/workbench/viewport/viewport_overlay.h"
#include "render/scene/visible_points.h"

namespace netpocket {
namespace {

constexpr double kKeyAngle = 5 * std::numbers::pi / 180;  // rad, of an arrow key
constexpr double kKeyPan = 0.05;                          // of the picture's height
constexpr double kKeyZoom = 1.15;
constexpr double kClickRadius = 4;  // pixels that the mouse may move in a click
constexpr int kRest = 150;          // ms without a change until the picture is smoothed

// From the same direction, the same side up.
bool look_alike(const CameraView& a, const CameraView& b) {
  constexpr double kSame = 1e-9;  // 1 - cosine
  const auto direction = [](const CameraView& view) -> Eigen::Vector3d {
    return (view.focal_point - view.position).normalized();
  };
  return direction(a).dot(direction(b)) > 1 - kSame && a.view_up.normalized().dot(b.view_up.normalized()) > 1 - kSame;
}

std::shared_ptr<const Snapshot> with_body_at(const Snapshot& snapshot, std::size_t body, const Eigen::Vector3d& place) {
  auto moved = std::make_shared<Snapshot>(snapshot);
  moved->bodies[body].position = place;
  return moved;
}

}  // namespace

Viewport::Viewport(PresenterKind kind, QWidget* parent)
    : QWidget(parent),
      presenter_(make_presenter(kind)),
      overlay_(new ViewportOverlay(this)),
      panel_(new PickPanel(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Viewport"));
  new FocusFrame(this);
  QWidget& screen = presenter_->widget();
  screen.setParent(this);
  screen.setAttribute(Qt::WA_TransparentForMouseEvents);
  screen.setFocusPolicy(Qt::NoFocus);
  screen.lower();
  state_.options = std::make_shared<const SceneOptions>();
  presenter_->shown = [this](const ViewState& shown, double seconds) { picture_came(shown, seconds); };
  presenter_->failed = [this](const QString& reason) {
    overlay_->set_message(tr("Nothing can be drawn: %1").arg(reason));
  };
  rest_.setSingleShot(true);
  rest_.setInterval(kRest);
  connect(&rest_, &QTimer::timeout, this, &Viewport::refine);
  connect(panel_, &PickPanel::closed, this, [this] { select(std::nullopt); });
  connect(panel_, &PickPanel::plot_requested, this, [this] {
    if (selection_) emit plot_requested(*selection_);
  });
}

Viewport::~Viewport() = default;

void Viewport::set_pocket(std::shared_ptr<const Structure> structure, std::shared_ptr<const Snapshot> snapshot) {
  const bool is_another_kind =
      structure && state_.structure && structure->element_groups != state_.structure->element_groups;
  if (structure != state_.structure) {
    // What was picked may not exist in another pocket.
    select(std::nullopt);
    measured_.clear();
    state_.history = nullptr;  // it fits the pocket before
    if (structure == nullptr || !state_.structure || structure->bodies.size() != state_.structure->bodies.size()) {
      end_drag();
    }
  }
  state_.structure = std::move(structure);
  // A preview comes later than the drag that it follows: the body stays under the mouse.
  if (drag_ == Drag::body && moved_ && snapshot) snapshot = with_body_at(*snapshot, dragged_body_, dragged_to_);
  set_snapshot(std::move(snapshot));
  if (is_another_kind) fit();  // another capture system may be of another size, elsewhere
}

void Viewport::set_snapshot(std::shared_ptr<const Snapshot> snapshot) {
  if (follow_ && state_.snapshot && snapshot && state_.structure) {
    const Eigen::Vector3d shift = target_position(*snapshot) - target_position(*state_.snapshot);
    state_.camera.position += shift;
    state_.camera.focal_point += shift;
  }
  state_.snapshot = std::move(snapshot);
  if (!state_.snapshot) state_.structure = nullptr;
  if (!framed_ && state_.complete() && width() > minimumSizeHint().width() / 2) {
    set_preset(preset_);
    return;
  }
  refresh();
}

void Viewport::set_history(std::shared_ptr<const SceneHistory> history) {
  if (state_.history == history) return;
  state_.history = std::move(history);
  refresh();
}

void Viewport::set_options(const SceneOptions& options) {
  state_.options = std::make_shared<const SceneOptions>(options);
  overlay_->set_dark(options.background == Background::space);
  refresh();
}

Eigen::Vector3d Viewport::target_position(const Snapshot& snapshot) const {
  for (std::size_t i = 0; i < state_.structure->bodies.size() && i < snapshot.bodies.size(); ++i) {
    if (state_.structure->bodies[i].role == BodyRole::target) return snapshot.bodies[i].position;
  }
  return Eigen::Vector3d::Zero();
}

void Viewport::set_preset(CameraPreset preset) {
  preset_ = preset;
  if (preset == CameraPreset::follow) set_follow_target(true);
  if (!state_.complete()) return;
  framed_ = true;
  looks_from_preset_ = true;
  aim(OrbitCamera(frame_view(preset, visible_points(*state_.structure, *state_.snapshot), aspect())));
}

void Viewport::fit() {
  if (!state_.complete()) return;
  const Eigen::Matrix3Xd points = visible_points(*state_.structure, *state_.snapshot);
  OrbitCamera camera(state_.camera);
  const Eigen::Vector3d center = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  camera.move(center - state_.camera.focal_point);
  // Backs off or comes nearer until everything just fits, keeping the direction.
  for (int round = 0; round < 12; ++round) {
    double reach = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const auto point = camera.project(points.col(i), size());
      if (!point) {
        reach = std::max(reach, 4.0);
        continue;
      }
      reach = std::max({reach, std::abs(2 * point->position.x() / width() - 1) / 0.86,
                        std::abs(2 * point->position.y() / height() - 1) / 0.88});
    }
    if (reach > 0) camera.zoom(1 / reach);
  }
  set_camera(camera);
}

void Viewport::set_view(const CameraView& view) { set_camera(OrbitCamera(view)); }

void Viewport::set_camera(const OrbitCamera& camera) {
  looks_from_preset_ = looks_from_preset_ && look_alike(state_.camera, camera.view());
  aim(camera);
}

void Viewport::aim(const OrbitCamera& camera) {
  framed_ = true;
  aimed_aspect_ = aspect();
  state_.camera = camera.view();
  refresh();
  emit view_changed();
}

void Viewport::set_follow_target(bool follow) { follow_ = follow; }

// Where no graphics device draws, smoothing takes most of a picture's time: what moves is better seen more often.
void Viewport::refresh() {
  state_.draft = state_.options->fast_smoothing;
  presenter_->show(state_);
  if (state_.draft) {
    rest_.start();
  } else {
    rest_.stop();
  }
}

void Viewport::refine() {
  state_.draft = false;
  presenter_->show(state_);
}

void Viewport::picture_came(const ViewState& shown, double seconds) {
  shown_ = shown;
  update_overlay(shown);
  if (shown.snapshot) emit picture_shown(shown.snapshot->time, seconds);
}

void Viewport::update_overlay(const ViewState& shown) {
  overlay_->set_camera(shown.camera);
  std::vector<Eigen::Vector3d> measured;
  std::optional<Eigen::Vector3d> selected;
  if (shown.complete()) {
    for (const Pick& pick : measured_) {
      if (const auto point = position_of(pick, *shown.structure, *shown.snapshot)) measured.push_back(*point);
    }
    if (selection_) selected = position_of(*selection_, *shown.structure, *shown.snapshot);
  }
  overlay_->set_measure(measured);
  overlay_->set_selection(selected);
  panel_->setVisible(selected.has_value());
  if (!selected) return;
  panel_->set_description(describe_pick(*selection_, *shown.structure, *shown.snapshot));
  place_panel();
}

void Viewport::select(const std::optional<Pick>& pick) {
  selection_ = pick;
  update_overlay(shown_);
  emit picked(selection_);
}

void Viewport::set_measuring(bool measuring) {
  measuring_ = measuring;
  measured_.clear();
  show_cursor();
  overlay_->set_hint(measuring ? tr("Click two points to measure their distance") : QString());
  update_overlay(shown_);
}

void Viewport::set_moving(bool moving) {
  if (!moving) end_drag();
  moving_ = moving;
  show_cursor();
  overlay_->set_hint(moving ? tr("Drag the target or the spacecraft; with Shift along one axis") : QString());
}

void Viewport::show_cursor() {
  setCursor(measuring_ ? Qt::CrossCursor : moving_ ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

void Viewport::set_hint(const QString& hint) { overlay_->set_hint(hint); }

void Viewport::set_message(const QString& message) { overlay_->set_message(message); }

void Viewport::place_panel() {
  constexpr int kMargin = 12;
  panel_->move(std::max(0, width() - panel_->width() - kMargin), kMargin);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  presenter_->widget().setGeometry(rect());
  overlay_->setGeometry(rect());
  place_panel();
  if (framed_) {
    keep_in_sight(event->oldSize());
  } else if (state_.complete()) {
    set_preset(preset_);
  }
}

double Viewport::aspect() const { return static_cast<double>(width()) / std::max(1, height()); }

// A view has a fixed angle upwards: where the picture becomes narrower than it was when somebody aimed it, backing off
// keeps at the sides what was seen there.
void Viewport::keep_in_sight(const QSize& before) {
  if (before.isEmpty()) return;
  const auto share = [this](double a) { return std::min(1.0, a / aimed_aspect_); };
  const double factor = share(aspect()) / share(static_cast<double>(before.width()) / before.height());
  if (factor == 1) return;
  OrbitCamera camera(state_.camera);
  camera.zoom(factor);
  state_.camera = camera.view();
  refresh();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  const bool shift = event->modifiers() & Qt::ShiftModifier, control = event->modifiers() & Qt::ControlModifier;
  switch (event->button()) {
    case Qt::LeftButton:
      drag_ = shift ? Drag::pan : control ? Drag::roll : Drag::orbit;
      if (moving_ && grab_body(event->position())) drag_ = Drag::body;
      break;
    case Qt::MiddleButton:
      drag_ = Drag::pan;
      break;
    case Qt::RightButton:
      drag_ = Drag::zoom;
      break;
    default:
      QWidget::mousePressEvent(event);
      return;
  }
  moved_ = false;
  pressed_at_ = last_ = event->position();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ == Drag::none) return;
  const QPointF way = event->position() - pressed_at_;
  moved_ = moved_ || std::hypot(way.x(), way.y()) > kClickRadius;
  if (!moved_) return;
  if (drag_ == Drag::body) {
    drag_body_to(event->position(), event->modifiers() & Qt::ShiftModifier);
  } else {
    drag_to(event->position());
  }
}

bool Viewport::grab_body(const QPointF& position) {
  const auto pick = body_at(state_, position, size());
  if (!pick) return false;
  dragged_body_ = static_cast<std::size_t>(pick->index);
  if (state_.structure->bodies[dragged_body_].role == BodyRole::other) return false;
  const auto grabbed = position_of(*pick, *state_.structure, *state_.snapshot);
  body_drag_ = BodyDrag(OrbitCamera(state_.camera), size(), *grabbed, state_.snapshot->bodies[dragged_body_].position);
  setCursor(Qt::ClosedHandCursor);
  emit body_drag_started();
  return true;
}

void Viewport::drag_body_to(const QPointF& position, bool along_one_axis) {
  dragged_to_ = body_drag_->center_at(position, along_one_axis);
  state_.snapshot = with_body_at(*state_.snapshot, dragged_body_, dragged_to_);
  refresh();
  emit body_dragged(state_.structure->bodies[dragged_body_].role, dragged_to_);
}

void Viewport::end_drag() {
  const bool body = std::exchange(drag_, Drag::none) == Drag::body;
  body_drag_.reset();
  show_cursor();
  if (body) emit body_drag_ended();
}

void Viewport::drag_to(const QPointF& position) {
  const QPointF step = (position - last_) / std::max(1, height());
  const QPointF center(width() / 2.0, height() / 2.0);
  const auto angle = [&](const QPointF& p) { return std::atan2(center.y() - p.y(), p.x() - center.x()); };
  OrbitCamera camera(state_.camera);
  // A drag over the picture's height is half a turn.
  if (drag_ == Drag::orbit) camera.orbit(std::numbers::pi * step.x(), -std::numbers::pi * step.y());
  if (drag_ == Drag::pan) camera.pan(step.x(), -step.y());
  if (drag_ == Drag::roll) camera.roll(angle(position) - angle(last_));
  if (drag_ == Drag::zoom) camera.zoom(std::exp(-3 * step.y()));
  last_ = position;
  set_camera(camera);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = drag_ != Drag::none && !moved_ && event->button() == Qt::LeftButton;
  end_drag();
  if (clicked) click(event->position());
}

void Viewport::click(const QPointF& position) {
  const auto pick = pick_at(shown_, position, size());
  if (!measuring_) {
    select(pick);
    return;
  }
  if (!pick) return;
  if (measured_.size() == 2) measured_.clear();
  measured_.push_back(*pick);
  update_overlay(shown_);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  const auto pick = pick_at(shown_, event->position(), size());
  if (!pick) return;
  const auto point = position_of(*pick, *shown_.structure, *shown_.snapshot);
  OrbitCamera camera(state_.camera);
  camera.move(*point - state_.camera.focal_point);
  set_camera(camera);
}

void Viewport::wheelEvent(QWheelEvent* event) {
  constexpr double kStep = 120;  // of one notch
  OrbitCamera camera(state_.camera);
  camera.zoom_at(event->position(), size(), std::pow(kKeyZoom, event->angleDelta().y() / kStep));
  set_camera(camera);
  event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  OrbitCamera camera(state_.camera);
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  const auto turn = [&](int right, int up) {
    if (shift) {
      camera.pan(kKeyPan * right, kKeyPan * up);
    } else {
      camera.orbit(kKeyAngle * right, kKeyAngle * up);
    }
  };
  switch (event->key()) {
    case Qt::Key_Left:
      turn(-1, 0);
      break;
    case Qt::Key_Right:
      turn(1, 0);
      break;
    case Qt::Key_Up:
      turn(0, 1);
      break;
    case Qt::Key_Down:
      turn(0, -1);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      camera.zoom(kKeyZoom);
      break;
    case Qt::Key_Minus:
      camera.zoom(1 / kKeyZoom);
      break;
    case Qt::Key_Escape:
      if (measuring_) measured_.clear();
      select(std::nullopt);
      return;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  set_camera(camera);
}

}  // namespace netpocket
