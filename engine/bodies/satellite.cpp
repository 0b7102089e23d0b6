#include "engine/bodies/satellite.h"

#include <algorithm>
#include <tuple>

namespace netpocket {
namespace {

// Proportions of a typical communications satellite, as fractions of the length in the comment.
constexpr double kArmShare = 0.16;         // distance from the bus to the tip
constexpr double kArmWidth = 0.12;         // width of the panel
constexpr double kPanelThickness = 0.035;  // width of the panel
constexpr double kMastLength = 0.10;       // diameter of the dish
constexpr double kMastRadius = 0.10;       // diameter of the dish
constexpr double kDishDepth = 0.20;        // diameter of the dish
constexpr double kNozzleRadius = 0.22;     // smaller width of the bus
constexpr double kNozzleLength = 0.28;     // smaller width of the bus

}  // namespace

Satellite::Satellite(const Dimensions& dimensions) : dimensions_(dimensions) {
  const Eigen::Vector3d& bus = dimensions.bus;
  const double wing = (dimensions.span - bus.x()) / 2, width = dimensions.panel_width;
  const double arm = kArmShare * wing, panel = wing - arm;
  const double dish = dimensions.dish_diameter, nozzle = std::min(bus.x(), bus.z());
  parts_[kBus] = {Box{bus}, {0, 0, 0}};
  for (const auto& [side, arm_index, panel_index] :
       {std::tuple(-1, kLeftArm, kLeftPanel), {1, kRightArm, kRightPanel}}) {
    const double root = bus.x() / 2;
    parts_[arm_index] = {Box{{arm, kArmWidth * width, kArmWidth * width}}, {side * (root + arm / 2), 0, 0}};
    parts_[panel_index] = {Box{{panel, width, kPanelThickness * width}}, {side * (root + arm + panel / 2), 0, 0}};
  }
  const double mast = kMastLength * dish, depth = kDishDepth * dish;
  parts_[kMast] = {Cylinder{kMastRadius * dish, mast}, {0, bus.y() / 2 + mast / 2, 0}};
  parts_[kDish] = {Cylinder{dish / 2, depth}, {0, bus.y() / 2 + mast + depth / 2, 0}};
  parts_[kNozzle] = {Cylinder{kNozzleRadius * nozzle, kNozzleLength * nozzle},
                     {0, -bus.y() / 2 - kNozzleLength * nozzle / 2, 0}};

  double whole = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Part& part : parts_) {
    const double share = std::visit([](const auto& solid) { return volume(solid); }, part.solid);
    whole += share;
    moment += share * part.centre;
  }
  for (Part& part : parts_) part.centre -= moment / whole;
}

}  // namespace netpocket
