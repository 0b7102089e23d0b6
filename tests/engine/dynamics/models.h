#pragma once
// What the tests of the dynamics share: materials, stepping, and sums over a whole system.

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "engine/dynamics/system/cable_system.h"
#include "engine/model/model.h"

namespace netpocket::test {

// The paper's net cord: d = 4 mm, E = 12 GPa, rho = 1430 kg/m^3. Without damping.
CableMaterial net_cord();

// A cable of a given section without contact radius.
CableMaterial plain_cable(double EA, double EI, double mass_per_length);

// A model with a straight cable from `begin` to `end`.
struct Cable {
  Model model;
  std::vector<std::int32_t> elements, nodes, gradients;  // along the cable
};
Cable straight_cable(const CableMaterial& material, const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                     int elements);

// Steps to `time` in equal steps of at most `largest`.
void advance(CableSystem& system, double time, double largest);

// Lets a system come to rest: whenever its kinetic energy has passed a maximum it starts again from where it is, at
// rest (dynamic relaxation with kinetic damping, Cundall 1976), until the kinetic energy of a maximum is below
// `kinetic_energy` (J) or `restarts` is reached. Returns the resting system.
CableSystem relax(const Model& model, const SystemOptions& options, double kinetic_energy, int restarts = 200);

// Mass of everything, kg.
double total_mass(const Model& model);
// Momenta of everything in a system over its last step.
struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   // N s
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  // N m s, about the origin
  double linear_scale = 0, angular_scale = 0;         // sums of the parts' sizes
};
// Makes one step of `dt` and returns the momentum after it: positions at its end, velocities over it. That is what
// leapfrog conserves. `evaluation` is the system's: consistent or lumped mass.
Momentum step_and_measure_momentum(CableSystem& system, double dt,
                                   ElementEvaluation evaluation = ElementEvaluation::mean_strain);

// Change of the momenta relative to the sum of the sizes of their parts.
struct MomentumDrift {
  double linear, angular;
};
MomentumDrift run_and_measure_drift(CableSystem& system, double time, double largest,
                                    ElementEvaluation evaluation = ElementEvaluation::mean_strain);

}  // namespace netpocket::test
