#pragma once
// Variable-length ropes during a run. Keeps the material length of their elements and the mass of their nodes up to
// date, computes the forces of the material's flow, and accounts for the energy of winding. Sources: Tang et al. (2023)
// Eqs. 2 to 15, as in ancf/variable_length.h.
//
// Lagrange's equations are integrated in terms of momentum. A step leads from n - 1/2 to n + 1/2, with the masses M and
// the flow momentum p at the start of each step:
//   M_n v_(n+1/2) + p_n - M_(n-1) v_(n-1/2) - p_(n-1) = kick (Q + dT/dq)
// So the sum over all nodes is constant to round-off, however fast the ropes are wound.
//
// World frame, SI units. Thread contract: one thread at a time.

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
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

// Material inside element `index` of a rope with `count` elements, whose nodes are spread evenly.
MaterialSpan rope_span(const RopeMotion& motion, double share_at_start, std::size_t index, std::size_t count);

class RopeDynamics {
 public:
  RopeDynamics(const Model& model, const CoordinateLayout& layout);

  bool empty() const { return ropes_.empty(); }

  // Sets a rope's motion at the end of the next step. Without this it keeps its rate and acceleration.
  void wind(std::int32_t rope, const RopeMotion& motion) { ropes_[static_cast<std::size_t>(rope)].next = motion; }

  // Derives the elements' spans from the ropes' present motion. Returns false if no rope has moved since the last call;
  // then lengths, masses and inertia are unchanged.
  bool refresh_spans();
  // Sets the elements' lengths in `batch`. Adds the lumped and the wound-up mass of the ropes to `mass` (by
  // coordinate), which must hold the mass of everything else.
  void update(ElementBatch& batch, std::span<double> mass);

  // Coordinates whose mass changes during the run, sorted.
  const std::vector<std::int32_t>& massive_coordinates() const { return massive_coordinates_; }

  // Adds the forces of the material's flow and of changing masses, for a kick of `kick` (s). `last_dt`: size of the
  // step before (s).
  void add_flow_forces(const CoordinateVectors& coordinates, const CoordinateVectors& velocities, double last_dt,
                       double kick, AppliedForces& applied);
  // Change (J) of the ropes' kinetic energy from the previous step's motion to the present one, at fixed coordinates
  // and velocities.
  double energy_change(const CoordinateVectors& coordinates, const CoordinateVectors& velocities);
  // To be called after each step of `dt` (s). The present motion becomes that of the previous step, and the commanded
  // motion becomes the present one.
  void finish_step(double dt);

  // Mean tensions (N) of the elements of the first ropes at their present motion, by the mean-strain evaluation.
  void mean_tensions(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                     std::span<double> tensions) const;

  // Kinetic energy (J) of the flow, in excess of that of lumped masses at their nodes' velocities, and flow_work (J) of
  // ancf/variable_length.h.
  struct FlowEnergy {
    double kinetic = 0, work = 0;
  };
  FlowEnergy flow_energy(const CoordinateVectors& coordinates, const CoordinateVectors& velocities) const;

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);
  // Takes the motions of another model's ropes: its rope i / `per_rope` * `stride` for rope i.
  void take_motions(const RopeDynamics& from, std::size_t per_rope, std::size_t stride);

  std::int32_t rope_count() const { return static_cast<std::int32_t>(ropes_.size()); }
  double element_length(std::int32_t rope) const { return ropes_[rope].spans.front().length; }
  const RopeMotion& motion(std::int32_t rope) const { return ropes_[rope].now; }
  // Span of a rope's element, by index into Model::elements; null for all other elements.
  const MaterialSpan* span_of(std::int32_t element) const;

 private:
  struct Rope {
    std::vector<std::int32_t> elements;
    std::vector<std::array<std::int32_t, 4>> indices{};  // by element of the rope
    std::vector<MaterialSpan> spans{};                   // by element of the rope, at present
    CableSection section;
    double share_at_start;
    double initial_length;             // m
    RopeMotion before, now;            // at the start of the previous and of the present step
    RopeMotion of_spans;               // motion that `spans` hold
    std::optional<RopeMotion> next{};  // commanded for the end of the present step

    // Whether the winding of this rope has any effect in this step.
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
  void set_present_spans();   // of the ropes' elements, and in the blocks
  void set_previous_spans();  // in the blocks

  std::vector<Rope> ropes_;
  AlignedVector<RopeBlock> blocks_;  // elements of all ropes, in the order of for_each_element
  bool started_ = false;             // whether spans have been set
  bool previous_spans_are_set_ = false;
  std::size_t longest_ = 0;  // number of elements of the longest rope
  std::vector<std::int32_t> massive_coordinates_;
  std::vector<std::pair<std::int32_t, std::int32_t>> place_;  // by element: (rope, index in it), or (-1, -1)
};

}  // namespace netpocket
