#include "engine/dynamics/system/leapfrog.h"

#include <algorithm>
#include <numeric>

#include "engine/dynamics/assembly/motion_bound.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

// Numbers of blocks that a thread moves at once, and of coordinates whose energies it sums in sequence. Constant, so
// that sums do not depend on the number of threads.
constexpr int kMoveChunk = 32, kEnergyRange = 8192;

update_kernel::Kernel update() {
  static const update_kernel::Kernel chosen = NETPOCKET_VARIANT_OF(update_kernel, update);
  return chosen;
}

}  // namespace

Leapfrog::Leapfrog(const Model& model, const CableElements& elements, const CableState& state, SystemForces& forces,
                   const SystemThreads& threads, const double* weights, const TiedCoordinates* ties)
    : elements_(elements),
      state_(state),
      forces_(forces),
      threads_(threads),
      weights_(weights),
      ties_(ties),
      unmoved_(state.layout.size()) {
  if (!elements.is_full()) return;
  consistent_mass_.emplace(model, state.layout, elements.mass(), elements.ropes().massive_coordinates());
  unit_mass_.assign(state.layout.size(), 1.0);
  collected_ = CoordinateVectors(state.layout.size());
}

// For the consistent mass the forces are collected first: a kick with unit masses from zero velocity leaves them in
// `collected_`.
std::optional<update_kernel::Fastest> Leapfrog::move(CoordinateVectors& v, CoordinateVectors& x, double kick,
                                                     double drift) {
  if (const TidalField* tide = forces_.tide()) tide->kick(v, kick);
  if (!consistent_mass_) {
    const auto fastest = kick_and_drift(v, x, elements_.inverse_mass(), kick, drift);
    if (ties_ != nullptr) ties_->follow(x, v);
    return fastest;
  }
  collected_.set_zero();
  kick_and_drift(collected_, unmoved_, unit_mass_, 1, 0);
  consistent_mass_->kick_and_drift(collected_, elements_.mass(), kick, drift, v, x);
  return std::nullopt;
}

// With a diagonal mass.
std::optional<update_kernel::Fastest> Leapfrog::kick_and_drift(CoordinateVectors& v, CoordinateVectors& x,
                                                               const AlignedVector<double>& inverse_mass, double kick,
                                                               double drift) {
  update_kernel::UpdateView view = forces_.view();
  view.inverse_mass = inverse_mass.data();
  view.coordinates = x.data();
  view.velocities = v.data();
  view.weight = weights_;
  view.gradient_block = state_.layout.gradient(0) / kBlockSize;
  if (forces_.are_waiting()) return forces_.move(view, update(), kick, drift);
  const auto move_blocks = [&](int first, int last) { return update()(view, first, last, kick, drift); };
  if (threads_.count() == 1) return move_blocks(0, forces_.block_count());
  update_kernel::Fastest fastest;
  for (const update_kernel::Fastest& part :
       values_of_ranges<update_kernel::Fastest>(threads_.loop(), forces_.block_count(), kMoveChunk, move_blocks)) {
    fastest = {larger_or_none(fastest.position, part.position), larger_or_none(fastest.gradient, part.gradient)};
  }
  return fastest;
}

CoordinateVectors Leapfrog::velocities_after(double kick) {
  CoordinateVectors velocity = state_.velocities;
  move(velocity, unmoved_, kick, 0);
  return velocity;
}

// J, without attachments. `squares`(first, count): squared speeds of `count` coordinates from `first` on.
template <typename Squares>
double Leapfrog::lumped_energy(const Squares& squares) const {
  const auto parts =
      values_of_ranges<double>(threads_.loop(), state_.layout.size(), kEnergyRange, [&](int first, int last) {
        const Eigen::Map<const Eigen::Array<double, kBlockSize, Eigen::Dynamic>> mass_of_blocks(
            elements_.moving_mass().data() + first, kBlockSize, (last - first) / kBlockSize);
        return 0.5 * (mass_of_blocks * squares(first, last - first)).sum();
      });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

double Leapfrog::kinetic_energy(const CoordinateVectors& velocity) const {
  if (consistent_mass_) return consistent_mass_->kinetic_energy(velocity, elements_.mass());
  return lumped_energy([&](int first, int count) { return velocity.squared_norms(first, count); });
}

// With a consistent mass a.M.v is half the difference of two kinetic energies, (v + a).M.(v + a)/2 - (v - a).M.(v -
// a)/2.
double Leapfrog::power(const CoordinateVectors& acceleration, const CoordinateVectors& velocity) const {
  if (!consistent_mass_) {
    using Block = Eigen::Map<const Eigen::Array<double, kBlockSize, kVectorRows>, Eigen::Aligned64>;
    Eigen::Array<double, kBlockSize, 1> sum = Eigen::Array<double, kBlockSize, 1>::Zero();
    const double* mass = elements_.moving_mass().data();
    for (std::int32_t first = 0; first < state_.layout.size(); first += kBlockSize) {
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(first) * kVectorRows;
      const Block a(acceleration.rows().first + row), v(velocity.rows().first + row);
      const Eigen::Map<const Eigen::Array<double, kBlockSize, 1>, Eigen::Aligned64> m(mass + first);
      sum += m * (a.col(0) * v.col(0) + a.col(1) * v.col(1) + a.col(2) * v.col(2));
    }
    return sum.sum();
  }
  CoordinateVectors sum = velocity, difference = velocity;
  for (std::int32_t i = 0; i < state_.layout.size(); ++i) {
    sum.add(i, acceleration.get(i));
    difference.add(i, -acceleration.get(i));
  }
  return 0.5 * (kinetic_energy(sum) - kinetic_energy(difference));
}

double Leapfrog::aliased_energy(const CoordinateVectors& velocity) const {
  return lumped_energy(
      [&](int first, int count) { return velocity.squared_distances(state_.velocities, first, count); });
}

}  // namespace netpocket
