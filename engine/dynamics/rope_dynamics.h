#pragma once
// Variable-length ropes during a run: keeps the material length of their elements, the mass of their nodes and the
// inertia of the material flow up to date. Sources: model.md's reading of Tang et al. (2023) Eqs. 2 to 15, as in
// ancf/variable_length.h.

#include <array>
#include <span>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/variable_length.h"
#include "engine/dynamics/slot_state.h"
#include "engine/model/model.h"

namespace netpocket {

class RopeDynamics {
 public:
  RopeDynamics(const Model& model, const SlotLayout& layout);

  bool empty() const { return ropes_.empty(); }

  // Replaces the law of winding of all ropes from now on.
  void set_motion(const std::function<RopeMotion(double)>& motion);

  // Goes to time `t` (s). False when every rope moves as it did before: then lengths, masses and inertia are as they
  // were.
  bool set_time(double t);
  // Sets lengths in `batch` and adds the ropes' lumped and wound-up mass to `mass` (by slot), which holds everything
  // else's.
  void update(ElementBatch& batch, std::span<double> mass);

  // Slots whose mass changes.
  const std::vector<std::int32_t>& massive_slots() const { return massive_slots_; }

  // Adds the forces of the material flow on nodes and gradients and of wound-in material on the end nodes.
  void add_flow_forces(const SlotVectors& coordinates, const SlotVectors& velocities, SlotVectors& applied) const;

  std::int32_t rope_count() const { return static_cast<std::int32_t>(ropes_.size()); }
  double element_length(std::int32_t rope) const { return ropes_[rope].spans.front().length; }
  const RopeMotion& motion(std::int32_t rope) const { return ropes_[rope].now; }
  // Span of an element of a rope (by index into Model::elements); nullptr for other elements.
  const MaterialSpan* span_of(std::int32_t element) const;

 private:
  struct Rope {
    std::vector<std::int32_t> elements;
    std::vector<std::array<std::int32_t, 4>> slots;  // of each element
    std::vector<MaterialSpan> spans;                 // of each element, now
    std::vector<SpanInertia> inertia;                // of each element, now; only a leader's
    CableSection section;
    std::function<RopeMotion(double)> motion;
    double share_at_start;
    double initial_length;
    RopeMotion now{};
    std::size_t leader;  // index of the rope whose inertia this one shares
  };

  template <typename Function>
  void for_each_element(const Function& function) const;
  void set_spans(Rope& rope);
  void set_inertia();
  void add_flow_forces(std::span<const Rope> alike, std::size_t index, const SlotVectors& coordinates,
                       const SlotVectors& velocities, SlotVectors& applied) const;

  std::vector<Rope> ropes_;
  bool started_ = false;     // a time has been set
  bool flowing_ = false;     // material moves relative to the nodes of a rope
  std::size_t longest_ = 0;  // elements of the longest rope
  std::vector<std::int32_t> massive_slots_;
  std::vector<std::pair<std::int32_t, std::int32_t>> place_;  // by element: (rope, index), or (-1, -1)
};

}  // namespace netpocket
