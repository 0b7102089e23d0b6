#pragma once
// A satellite as a target: a bus with two solar panels, a dish and an engine nozzle. It consists of boxes and cylinders
// that touch but do not overlap. Lengths in m. Body axes: the panels extend along x and face z, the dish is at +y, the
// nozzle at -y. The origin is the centroid of the volume.

#include <Eigen/Core>
#include <array>
#include <variant>

#include "engine/bodies/primitives.h"

namespace netpocket {

class Satellite {
 public:
  struct Dimensions {
    Eigen::Vector3d bus;  // edges of the bus
    double span;          // from tip to tip of the panels, along x; must exceed bus.x
    double panel_width;   // along y
    double dish_diameter;
    bool operator==(const Dimensions&) const = default;
  };
  struct Part {
    std::variant<Box, Cylinder> solid;
    Eigen::Vector3d centre;
  };
  enum PartIndex { kBus, kLeftArm, kRightArm, kLeftPanel, kRightPanel, kMast, kDish, kNozzle, kPartCount };

  explicit Satellite(const Dimensions& dimensions);

  const Dimensions& dimensions() const { return dimensions_; }
  const std::array<Part, kPartCount>& parts() const { return parts_; }
  const Part& part(PartIndex index) const { return parts_[index]; }

 private:
  Dimensions dimensions_;
  std::array<Part, kPartCount> parts_;
};

}  // namespace netpocket
