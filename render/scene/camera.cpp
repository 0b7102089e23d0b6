#include "render/scene/camera.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "render/render_error.h"

namespace netpocket {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// How a preset looks at the pocket, whose axis is the world's Y.
struct Direction {
  Eigen::Vector3d towards_viewer;
  double axis_angle;  // degrees, of the pocket's axis in the picture from the horizontal; ignored when it points at the
                      // viewer
  double view_angle;  // degrees; 0: parallel projection
};

Direction direction_of(CameraPreset preset) {
  switch (preset) {
    case CameraPreset::side:
      return {{0, 0, 1}, 0, 0};
    case CameraPreset::front:
      return {{0, 1, 0}, 0, 0};
    case CameraPreset::mouth:
      return {{0.16, 0.76, 0.63}, 82, 34};
    case CameraPreset::iso:
    case CameraPreset::follow:
      break;
  }
  return {{0.60, 0.38, 0.70}, 26, 26};
}

// Columns: right, up and towards the viewer, in the world.
Eigen::Matrix3d picture_axes(const Direction& direction) {
  const Eigen::Vector3d forward = direction.towards_viewer.normalized();
  Eigen::Vector3d along = Eigen::Vector3d::UnitY() - forward.y() * forward;
  if (along.norm() < 1e-9) along = Eigen::Vector3d::UnitX();
  along.normalize();
  const Eigen::Vector3d across = forward.cross(along);
  const double angle = direction.axis_angle * kDegree;
  Eigen::Matrix3d axes;
  axes.col(0) = std::cos(angle) * along - std::sin(angle) * across;
  axes.col(1) = std::sin(angle) * along + std::cos(angle) * across;
  axes.col(2) = forward;
  return axes;
}

// Slopes under which a perspective camera at `eye` (picture axes) sees the points.
struct Slopes {
  Eigen::Array2d low;
  Eigen::Array2d high;
};
Slopes slopes_from(const Eigen::Vector3d& eye, const Eigen::Matrix3Xd& points) {
  const auto depth = (eye.z() - points.row(2).array()).eval();
  Slopes slopes;
  for (int i = 0; i < 2; ++i) {
    const auto slope = ((points.row(i).array() - eye[i]) / depth).eval();
    slopes.low[i] = slope.minCoeff();
    slopes.high[i] = slope.maxCoeff();
  }
  return slopes;
}

// Eye of a perspective camera that sees the points (picture axes) within +-limit, by alternately centring and backing
// off.
Eigen::Vector3d fitted_eye(const Eigen::Matrix3Xd& points, const Eigen::Array2d& limit) {
  const Eigen::Vector3d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  Eigen::Vector3d eye = (low + high) / 2;
  const double reach = std::max((high - low).norm(), 1e-3);
  eye.z() = high.z() + reach / limit.minCoeff();
  for (int round = 0; round < 30; ++round) {
    const auto slopes = slopes_from(eye, points);
    const double distance = eye.z() - (low.z() + high.z()) / 2;
    eye.head<2>() += (distance * (slopes.low + slopes.high) / 2).matrix();
    const double filled = ((slopes.high - slopes.low) / 2 / limit).maxCoeff();
    eye.z() = std::max((low.z() + high.z()) / 2 + distance * filled, high.z() + 1e-3 * reach);
  }
  return eye;
}

}  // namespace

CameraPreset camera_from_name(std::string_view name) {
  if (name == "iso") return CameraPreset::iso;
  if (name == "side") return CameraPreset::side;
  if (name == "front") return CameraPreset::front;
  if (name == "mouth") return CameraPreset::mouth;
  if (name == "follow") return CameraPreset::follow;
  throw RenderError(fmt::format("unknown camera '{}': use iso, side, front, mouth or follow", name));
}

CameraView frame_view(CameraPreset preset, const Eigen::Matrix3Xd& points, double aspect, const FramingShare& share) {
  const auto direction = direction_of(preset);
  const Eigen::Matrix3d axes = picture_axes(direction);
  if (points.cols() == 0) return {};
  const Eigen::Matrix3Xd seen = axes.transpose() * points;
  const Eigen::Vector3d low = seen.rowwise().minCoeff(), high = seen.rowwise().maxCoeff();
  const Eigen::Array2d filled(share.width * aspect, share.height);

  CameraView view;
  view.view_up = axes.col(1);
  if (direction.view_angle == 0) {
    const Eigen::Vector3d center = (low + high) / 2;
    view.half_height = std::max(((high - low).head<2>().array() / 2 / filled).maxCoeff(), 1e-3);
    view.focal_point = axes * center;
    view.position = view.focal_point + 2 * (high - low).norm() * axes.col(2);
    return view;
  }
  view.view_angle = direction.view_angle;
  const Eigen::Vector3d eye = fitted_eye(seen, std::tan(view.view_angle / 2 * kDegree) * filled);
  view.position = axes * eye;
  view.focal_point = axes * Eigen::Vector3d(eye.x(), eye.y(), (low.z() + high.z()) / 2);
  return view;
}

void apply_view(const CameraView& view, vtkCamera& camera) {
  camera.SetPosition(view.position.data());
  camera.SetFocalPoint(view.focal_point.data());
  camera.SetViewUp(view.view_up.data());
  camera.SetViewAngle(view.view_angle);
  camera.SetParallelProjection(view.half_height > 0);
  if (view.half_height > 0) camera.SetParallelScale(view.half_height);
}

}  // namespace netpocket
