#pragma once
// Ropes without mass that run through rings (RingRope of model.h), during a run: how much rope each of their parts has,
// their tensions, and the energy that winding and rings take or give. The flow through rings: ring_flow.h.
//
// A step first moves the nodes, then winds, then lets rope run through the rings. So with the strain e of a part, its
// tension T = T_e + T_d of spring and damper and its length L, the energy of a step consists of
//   dU = T_e dl - N_e dL,  N_e = T_e (1 + e/2)      of the spring, U = EA L e^2/2
//   T_d L de >= 0                                   spent in the damper
//   (N_2 - N_1) f >= 0,  N = N_e + T_d (1 + e)      spent at a ring that the length f passes from part 1 to part 2
//   N w                                             input by a winch that winds in the length w
// Each is summed with the mean of its forces at the two ends of the step. The sum of all parts and of what is wound is
// constant to round-off, because what one part loses another gains.
//
// World frame, SI units. Thread contract: one thread at a time.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/ropes/ring_flow.h"
#include "engine/model/model.h"

namespace netpocket {

class RingRopes {
 public:
  RingRopes(const Model& model, const CoordinateLayout& layout);

  bool empty() const { return ropes_.empty(); }

  // Sets a rope's motion at the end of the next step. Without this it keeps its rate and acceleration.
  void wind(std::size_t rope, const RopeMotion& motion) { ropes_[rope].next = motion; }
  // Tensions at these positions, without damping. To be called when positions have changed in another way than by a
  // step.
  void stretch(const CoordinateVectors& coordinates);

  // J, of a step.
  struct Work {
    double input = 0;  // of winches
    double in_dampers = 0, at_rings = 0;
  };
  // To be called when a step of `dt` (s) has moved all nodes.
  Work advance(const CoordinateVectors& coordinates, double dt);

  // Adds the tensions to the forces on the nodes.
  void add_forces(const CoordinateVectors& coordinates, AppliedForces& applied) const;
  double energy() const;  // J

  const RopeMotion& motion(std::size_t rope) const { return ropes_[rope].now; }
  // Mean tension (N) of the parts at the two ends, which winches there feel.
  double tension(std::size_t rope) const;
  // By part: natural length (m) and tension (N).
  std::vector<double> lengths(std::size_t rope) const;
  std::vector<double> tensions(std::size_t rope) const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Part {
    double length = 0;   // m
    double strain = 0;   // >= 0
    double tension = 0;  // N
  };
  struct Rope {
    std::vector<std::int32_t> places;  // coordinates of its nodes
    std::vector<Part> parts;
    RingLaw law;
    double friction, extra_angle, share_at_start;
    RopeMotion now;
    std::optional<RopeMotion> next{};
  };

  static double flow_tension(const Rope& rope, const Part& part);
  static double damper_tension(const Rope& rope, const Part& part);
  Work advance(Rope& rope, const CoordinateVectors& coordinates, double dt);
  void find_ratios(const Rope& rope, const CoordinateVectors& coordinates);

  std::vector<Rope> ropes_;
  RingFlow flow_;
  std::vector<RingPart> stretched_;  // parts of one rope
  std::vector<double> ratios_;       // of its rings
  std::vector<Part> before_;
};

}  // namespace netpocket
