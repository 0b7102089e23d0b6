#pragma once
// The tide of a model's orbit (orbit/reference_orbit.h) on everything of a system. Internal to this room.
//
// A point of a cable is r = S e, linear in its nodal coordinates e, and so is the tidal acceleration G r. The
// generalised force of the tide on an element, integral of m S^T G S e dp, is the mass matrix times G applied to each
// coordinate:
//   e'' = M^-1 F + G e,  for positions and gradients alike, with lumped and with consistent mass.
// On a rigid body with the second moments J = tr(I)/2 - I act the force m G r and the torque of all rho x G rho, which
// is that of the antisymmetric part of J G. For a point mass: 3 mu/R^3 (r x I r) with the unit vector r from the Earth;
// Schaub & Junkins, Analytical Mechanics of Space Systems, section 4.4.

#include <optional>
#include <vector>

#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"

namespace netpocket {

class TidalField {
 public:
  // Both must outlive this object.
  TidalField(const Orbit& orbit, const CableElements& elements, const CableState& state);

  // At the present state.
  void compute();
  const CoordinateVectors& accelerations() const { return accelerations_; }  // m/s^2, 1/s^2: of free coordinates
  const Wrench& wrench(std::size_t body) const { return wrenches_[body]; }
  // v += kick times the accelerations.
  void kick(CoordinateVectors& v, double kick) const;

 private:
  ReferenceOrbit orbit_;
  const CableState& state_;
  CoordinateVectors accelerations_;
  std::vector<double> is_free_;  // by coordinate: 1, or 0 for those that do not move by themselves
  std::vector<Wrench> wrenches_;
};

}  // namespace netpocket
