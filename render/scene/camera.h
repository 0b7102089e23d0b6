#pragma once
// Where a pocket is looked at from. Views are framed in the world, not in pixels: the same at any resolution.

#include <vtkCamera.h>

#include <Eigen/Core>
#include <string_view>

namespace netpocket {

enum class CameraPreset {
  iso,     // from the side and a little ahead, the pocket's axis rising to the right
  side,    // square to the axis, which lies level; parallel projection
  front,   // along the axis, looking into the mouth; parallel projection
  mouth,   // obliquely into the mouth, close
  follow,  // as iso, moving with the target
};

// Throws RenderError for an unknown name.
CameraPreset camera_from_name(std::string_view name);

struct CameraView {
  Eigen::Vector3d position{0, 0, 1};     // m, world
  Eigen::Vector3d focal_point{0, 0, 0};  // m, world
  Eigen::Vector3d view_up{0, 1, 0};
  double view_angle = 30;  // degrees, vertical
  double half_height = 0;  // m, of what is seen in parallel projection; 0: perspective
};

// Share of a picture's width and height that the framed points may take.
struct FramingShare {
  double width = 0.80;  // leaves room for labels at the sides
  double height = 0.88;
};

// The view of a preset that just shows all points (m, world, one column each) in a picture of `aspect` = width /
// height.
CameraView frame_view(CameraPreset preset, const Eigen::Matrix3Xd& points, double aspect,
                      const FramingShare& share = {});

void apply_view(const CameraView& view, vtkCamera& camera);

}  // namespace netpocket
