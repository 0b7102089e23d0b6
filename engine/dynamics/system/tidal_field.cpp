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
  using Lanes = Eigen::Array<double, kBlockSize, 1>;
  const double* position = state_.coordinates.rows().first;
  double* acceleration = accelerations_.data();
  for (std::int32_t first = 0; first < state_.layout.size(); first += kBlockSize) {
    const Eigen::Map<const Eigen::Array<double, kBlockSize, kVectorRows>, Eigen::Aligned64> x(position);
    Eigen::Map<Eigen::Array<double, kBlockSize, kVectorRows>, Eigen::Aligned64> a(acceleration);
    const Eigen::Map<const Lanes> is_free(is_free_.data() + first);
    for (int row = 0; row < kVectorRows; ++row) {
      a.col(row) = is_free * (tide(row, 0) * x.col(0) + tide(row, 1) * x.col(1) + tide(row, 2) * x.col(2));
    }
    position += kTidalBlock;
    acceleration += kTidalBlock;
  }
  for (std::size_t b = 0; b < wrenches_.size(); ++b) wrenches_[b] = tide_on(state_.bodies[b].rigid(), tide);
}

void TidalField::kick(CoordinateVectors& v, double kick) const {
  const Eigen::Index count = static_cast<Eigen::Index>(state_.layout.size()) * kVectorRows;
  Eigen::Map<Eigen::ArrayXd, Eigen::Aligned64>(v.data(), count) +=
      kick * Eigen::Map<const Eigen::ArrayXd, Eigen::Aligned64>(accelerations_.rows().first, count);
}

}  // namespace netpocket
