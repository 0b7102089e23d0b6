#pragma once
// Variable-length ropes during a run: keeps the material length of their elements and the mass of their nodes up to
// date, gives the forces of the material's flow and accounts for the energy of winding. Sources: Tang et al. (2023)
// Eqs. 2 to 15, as in ancf/variable_length.h.
//
// Lagrange's equations are stepped in momenta: over a step from n - 1/2 to n + 1/2, with the masses M and the flow
// momentum p of the step's start,
//   M_n v_(n+1/2) + p_n - M_(n-1) v_(n-1/2) - p_(n-1) = kick (Q + dT/dq)
// so that the sum over all nodes is constant to round-off however fast the ropes are wound.

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/variable_length.h"
#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/ropes/rope_kernel.h"
#include "engine/model/model.h"

namespace netpocket {

// Material inside element `index` of a rope's `count`, whose nodes are evenly spread.
MaterialSpan rope_span(const RopeMotion& motion, double share_at_start, std::size_t index, std::size_t count);

class RopeDynamics {
 public:
  RopeDynamics(const Model& model, const CoordinateLayout& layout);

  bool empty() const { return ropes_.empty(); }

  // Replaces the law of winding of all ropes from now on.
  void set_motion(const std::function<RopeMotion(double)>& motion);

  // Goes to time `t` (s). False when every rope moves as it did before: then lengths, masses and inertia are as they
  // were.
  bool set_time(double t);
  // Sets lengths in `batch` and adds the ropes' lumped and wound-up mass to `mass` (by coordinate), which holds
  // everything else's.
  void update(ElementBatch& batch, std::span<double> mass);

  // Coordinates whose mass changes.
  const std::vector<std::int32_t>& massive_coordinates() const { return massive_coordinates_; }

  // Adds the forces of the material's flow and of masses that change, for a kick of `kick` (s); the step before was
  // `last_dt` (s) long.
  void add_flow_forces(const CoordinateVectors& coordinates, const CoordinateVectors& velocities, double last_dt,
                       double kick, AppliedForces& applied);
  // What the ropes' kinetic energy changes by from the previous step's motion to the present one at fixed coordinates
  // and velocities. J
  double energy_change(const CoordinateVectors& coordinates, const CoordinateVectors& velocities);
  // The present motion is from now on the previous step's.
  void finish_step();

  // Kinetic energy of the flow, beyond that of lumped masses at their nodes' velocities; and flow_work of
  // ancf/variable_length.h. J
  struct FlowEnergy {
    double kinetic = 0, work = 0;
  };
  FlowEnergy flow_energy(const CoordinateVectors& coordinates, const CoordinateVectors& velocities) const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

  std::int32_t rope_count() const { return static_cast<std::int32_t>(ropes_.size()); }
  double element_length(std::int32_t rope) const { return ropes_[rope].spans.front().length; }
  const RopeMotion& motion(std::int32_t rope) const { return ropes_[rope].now; }
  // Span of an element of a rope (by index into Model::elements); nullptr for other elements.
  const MaterialSpan* span_of(std::int32_t element) const;

 private:
  struct Rope {
    std::vector<std::int32_t> elements;
    std::vector<std::array<std::int32_t, 4>> indices;  // of each element
    std::vector<MaterialSpan> spans;                   // of each element, now
    CableSection section;
    std::function<RopeMotion(double)> motion;
    std::int32_t same_motion_as;  // an earlier rope with the same motion, or -1
    double share_at_start;
    double initial_length;
    RopeMotion before{}, now{};  // at the start of the previous step, and at that of the present one

    // The winding of this rope makes a difference in this step.
    bool moves() const { return now.rate != 0 || before.rate != 0 || now.length != before.length; }
    MaterialSpan span_at(const RopeMotion& motion_then, std::size_t index) const {
      return rope_span(motion_then, share_at_start, index, elements.size());
    }
    double wound_mass(const RopeMotion& motion_then) const {
      return section.mass_per_length * (initial_length - motion_then.length);
    }
  };

  template <typename Function>
  void for_each_element(const Function& function) const;
  template <typename Function>
  void for_each_end(const Function& function) const;
  bool moves() const { return std::ranges::any_of(ropes_, &Rope::moves); }
  void collect_blocks();
  template <typename Function>
  void for_each_lane(const Function& function);
  void set_present_spans();   // of the ropes' elements and in the blocks
  void set_previous_spans();  // in the blocks

  std::vector<Rope> ropes_;
  AlignedVector<RopeBlock> blocks_;  // their elements in the order of for_each_element
  bool started_ = false;             // a time has been set
  bool previous_spans_are_set_ = false;
  std::size_t longest_ = 0;  // elements of the longest rope
  std::vector<std::int32_t> massive_coordinates_;
  std::vector<std::pair<std::int32_t, std::int32_t>> place_;  // by element: (rope, index), or (-1, -1)
};

}  // namespace netpocket
