#include "engine/dynamics/system/tidal_field.h"

namespace netpocket {
namespace {

constexpr std::ptrdiff_t kTidalBlock = static_cast<std::ptrdiff_t>(kVectorRows) * kBlockSize;

Wrench tide_on(const RigidBody& body, const Eigen::Matrix3d& tide) {
  const Eigen::Matrix3d moments = 0.5 * body.inertia().trace() * Eigen::Matrix3d::Identity() - body.inertia();
  const Eigen::Matrix3d turned = body.rotation() * moments * body.rotation().transpose() * tide;
  return {body.mass() * (tide * body.position()),
          {turned(1, 2) - turned(2, 1), turned(2, 0) - turned(0, 2), turned(0, 1) - turned(1, 0)}};
}

}  // namespace

TidalField::TidalField(const Orbit& orbit, const CableElements& elements, const CableState& state)
    : orbit_(orbit), state_(state), accelerations_(state.layout.size()), wrenches_(state.bodies.size()) {
  for (const double inverse_mass : elements.inverse_mass()) is_free_.push_back(inverse_mass > 0 ? 1 : 0);
}

void TidalField::compute() {
  const Eigen::Matrix3d tide = orbit_.tide(state_.time);
  const double* position = state_.coordinates.rows().first;
  double* acceleration = accelerations_.data();
  for (std::int32_t first = 0; first < state_.layout.size(); first += kBlockSize) {
    for (int row = 0; row < kVectorRows; ++row) {
      for (int lane = 0; lane < kBlockSize; ++lane) {
        acceleration[row * kBlockSize + lane] =
            is_free_[static_cast<std::size_t>(first + lane)] *
            (tide(row, 0) * position[lane] + tide(row, 1) * position[kBlockSize + lane] +
             tide(row, 2) * position[2 * kBlockSize + lane]);
      }
    }
    position += kTidalBlock;
    acceleration += kTidalBlock;
  }
  for (std::size_t b = 0; b < wrenches_.size(); ++b) wrenches_[b] = tide_on(state_.bodies[b].rigid(), tide);
}

void TidalField::kick(CoordinateVectors& v, double kick) const {
  const double* acceleration = accelerations_.rows().first;
  double* velocity = v.data();
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(state_.layout.size()) * kVectorRows;
  for (std::ptrdiff_t i = 0; i < count; ++i) velocity[i] += kick * acceleration[i];
}

}  // namespace netpocket
