#pragma once
// The integrator of a system: explicit symplectic integration with velocities at half steps. It knows masses and forces
// but not where forces come from. Internal to this room.
//
//   v(n + 1/2) = v(n - 1/2) + kick M^-1 F(n),  kick = half of the last and half of the next step
//   x(n + 1)   = x(n) + dt v(n + 1/2)

#include <optional>

#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/consistent_mass.h"
#include "engine/dynamics/assembly/update_kernel.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/system_forces.h"
#include "engine/dynamics/system/system_threads.h"

namespace netpocket {

class Leapfrog {
 public:
  // All must outlive this object. `weights`: of coordinates, for the speeds that it finds (update_kernel.h). Throws
  // std::invalid_argument if the consistent mass matrix of the full evaluation is singular.
  Leapfrog(const Model& model, const CableElements& elements, const CableState& state, SystemForces& forces,
           const SystemThreads& threads, const double* weights, const TiedCoordinates* ties = nullptr);

  // Time (s) over which the present forces act in a step of `dt` (s). At the start velocities do not lag.
  double kick(double dt) const { return 0.5 * (state_.last_step + dt); }

  // Moves free coordinates by the present forces: v += kick M^-1 F, x += drift v. Returns the largest speeds if it has
  // found them.
  std::optional<update_kernel::Fastest> move(CoordinateVectors& v, CoordinateVectors& x, double kick, double drift);
  // The velocities of the state after a kick (s) with the present forces. Half of the last step brings them to the time
  // of the positions.
  CoordinateVectors velocities_after(double kick);

  // J, of free coordinates at these velocities.
  double kinetic_energy(const CoordinateVectors& velocity) const;
  // W: of forces that give free coordinates these accelerations, at these velocities.
  double power(const CoordinateVectors& acceleration, const CoordinateVectors& velocity) const;
  // J. Velocities half a step apart differ by the waves that the step does not resolve. The energy of the difference is
  // the aliased energy.
  double aliased_energy(const CoordinateVectors& velocity) const;

 private:
  std::optional<update_kernel::Fastest> kick_and_drift(CoordinateVectors& v, CoordinateVectors& x,
                                                       const AlignedVector<double>& inverse_mass, double kick,
                                                       double drift);
  template <typename Squares>
  double lumped_energy(const Squares& squares) const;

  const CableElements& elements_;
  const CableState& state_;
  SystemForces& forces_;
  const SystemThreads& threads_;
  const double* weights_;
  const TiedCoordinates* ties_;
  std::optional<ConsistentMass> consistent_mass_;  // of the full evaluation
  AlignedVector<double> unit_mass_;
  CoordinateVectors collected_;  // forces, for the consistent mass
  CoordinateVectors unmoved_;    // positions for kicks without drift
};

}  // namespace netpocket
