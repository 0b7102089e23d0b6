#include "gui/workbench/viewport/picker.h"

#include <cmath>

#include "render/scene/element_curve.h"

namespace netpocket {
namespace {

constexpr double kCatchRadius = 7;      // pixels
constexpr double kNodeRadius = 6;       // pixels, of nodes, which lie on cords and come first
constexpr double kHiddenMargin = 0.05;  // m, by which a cord may lie behind a body's surface and still be caught
constexpr int kSegments = 4;            // straight pieces of an element

struct BodyHit {
  std::int32_t body = -1;
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector3d local{0, 0, 0};
};

// Sphere tracing: steps by the distance to the surface, which is exact.
std::optional<double> trace(const Shape& shape, const ViewRay& ray, double farthest) {
  constexpr double kOnSurface = 1e-4;
  double travelled = 0;
  for (int i = 0; i < 200 && travelled < farthest; ++i) {
    const double distance = nearest_surface_point(shape, ray.origin + travelled * ray.direction).distance;
    if (distance < kOnSurface) return travelled;
    travelled += distance;
  }
  return std::nullopt;
}

BodyHit nearest_body(const ViewState& state, const ViewRay& ray) {
  BodyHit best;
  for (std::size_t i = 0; i < state.structure->bodies.size(); ++i) {
    const BodyState& body = state.snapshot->bodies[i];
    const auto& shape = state.structure->bodies[i].shape;
    const Eigen::Quaterniond to_body = body.attitude.conjugate();
    const ViewRay local{to_body * (ray.origin - body.position), to_body * ray.direction};
    const double farthest = local.origin.norm() + bounding_radius(shape);
    const auto distance = trace(shape, local, farthest);
    if (!distance || *distance >= best.distance) continue;
    best = {static_cast<std::int32_t>(i), *distance, local.origin + *distance * local.direction};
  }
  return best;
}

double length(const QPointF& p) { return std::hypot(p.x(), p.y()); }

// How far, in pixels, a point is from a segment, and where along it the nearest point is.
struct SegmentDistance {
  double distance;
  double fraction;
};
SegmentDistance distance_to_segment(const QPointF& point, const QPointF& a, const QPointF& b) {
  const QPointF along = b - a;
  const double square = QPointF::dotProduct(along, along);
  const double fraction = square > 0 ? std::clamp(QPointF::dotProduct(point - a, along) / square, 0.0, 1.0) : 0;
  return {length(point - a - fraction * along), fraction};
}

class CordPicker {
 public:
  CordPicker(const ViewState& state, const QPointF& position, const QSizeF& size, double farthest)
      : state_(state), camera_(state.camera), position_(position), size_(size), farthest_(farthest) {}

  std::optional<Pick> pick() {
    pick_nodes();
    if (!best_) pick_elements();
    return best_;
  }

 private:
  // Of two things within reach, the nearer to the viewer; depths that hardly differ are decided by the screen.
  void offer(const Pick& pick, double pixels, double depth) {
    if (depth > farthest_) return;
    constexpr double kMetresPerPixel = 0.2;
    const double score = depth + kMetresPerPixel * pixels;
    if (best_ && score >= score_) return;
    best_ = pick;
    score_ = score;
  }

  void pick_nodes() {
    const auto& positions = state_.snapshot->positions;
    for (Eigen::Index i = 0; i < positions.cols(); ++i) {
      const auto point = camera_.project(positions.col(i), size_);
      if (!point) continue;
      const double pixels = length(point->position - position_);
      if (pixels < kNodeRadius)
        offer({PickKind::node, static_cast<std::int32_t>(i), 0, {0, 0, 0}}, pixels, point->depth);
    }
  }

  void pick_elements() {
    for (std::size_t i = 0; i < state_.structure->elements.size(); ++i) pick_element(static_cast<std::int32_t>(i));
  }

  void pick_element(std::int32_t index) {
    const auto& element = state_.structure->elements[static_cast<std::size_t>(index)];
    std::optional<ScreenPoint> before;
    for (int i = 0; i < curve_.point_count(); ++i) {
      const auto point = camera_.project(curve_.position(*state_.snapshot, element, i), size_);
      if (before && point) pick_segment(index, i - 1, *before, *point);
      before = point;
    }
  }

  void pick_segment(std::int32_t element, int segment, const ScreenPoint& a, const ScreenPoint& b) {
    const auto near = distance_to_segment(position_, a.position, b.position);
    if (near.distance > kCatchRadius) return;
    const double fraction = (segment + near.fraction) / kSegments;
    offer({PickKind::element, element, fraction, {0, 0, 0}}, near.distance,
          a.depth + near.fraction * (b.depth - a.depth));
  }

  const ViewState& state_;
  OrbitCamera camera_;
  QPointF position_;
  QSizeF size_;
  double farthest_;
  ElementCurve curve_{kSegments};
  std::optional<Pick> best_;
  double score_ = 0;
};

}  // namespace

std::optional<Pick> pick_at(const ViewState& state, const QPointF& position, const QSizeF& size) {
  if (!state.complete() || size.isEmpty()) return std::nullopt;
  const OrbitCamera camera(state.camera);
  const ViewRay ray = camera.ray(position, size);
  const BodyHit body = nearest_body(state, ray);
  const Eigen::Vector3d forward = (state.camera.focal_point - state.camera.position).normalized();
  const double depth = body.distance * ray.direction.dot(forward);
  if (const auto cord = CordPicker(state, position, size, depth + kHiddenMargin).pick()) return cord;
  if (body.body < 0) return std::nullopt;
  return Pick{PickKind::body, body.body, 0, body.local};
}

std::optional<Pick> body_at(const ViewState& state, const QPointF& position, const QSizeF& size) {
  if (!state.complete() || size.isEmpty()) return std::nullopt;
  const BodyHit body = nearest_body(state, OrbitCamera(state.camera).ray(position, size));
  if (body.body < 0) return std::nullopt;
  return Pick{PickKind::body, body.body, 0, body.local};
}

std::optional<Eigen::Vector3d> position_of(const Pick& pick, const Structure& structure, const Snapshot& snapshot) {
  const auto index = static_cast<std::size_t>(pick.index);
  switch (pick.kind) {
    case PickKind::node:
      if (pick.index >= snapshot.positions.cols()) return std::nullopt;
      return snapshot.positions.col(pick.index);
    case PickKind::element: {
      if (index >= structure.elements.size()) return std::nullopt;
      // The curve's stations divide it evenly; its finest division is taken.
      constexpr int kStations = 64;
      static const ElementCurve curve(kStations);
      return curve.position(snapshot, structure.elements[index],
                            static_cast<int>(std::lround(pick.fraction * kStations)));
    }
    case PickKind::body:
      if (index >= snapshot.bodies.size()) return std::nullopt;
      return snapshot.bodies[index].position + snapshot.bodies[index].attitude * pick.local;
  }
  return std::nullopt;
}

}  // namespace netpocket
