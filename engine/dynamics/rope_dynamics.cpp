#include "engine/dynamics/rope_dynamics.h"

#include <algorithm>
#include <array>

#include "engine/ancf/mass.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/variable_length.h"

namespace netpocket {
namespace {

ElementCoordinates gather(const SlotVectors& vectors, const std::array<std::int32_t, 4>& slots) {
  ElementCoordinates q;
  for (int i = 0; i < 4; ++i) q.col(i) = vectors.get(slots[i]);
  return q;
}

}  // namespace

RopeDynamics::RopeDynamics(const Model& model, const SlotLayout& layout) {
  place_.assign(model.elements.size(), {-1, -1});
  for (const VariableRope& source : model.ropes) {
    Rope rope;
    rope.elements = source.elements;
    rope.section = model.material_of(source.elements.front()).section;
    rope.motion = source.motion;
    rope.share_at_start = source.share_at_start;
    rope.initial_length = source.motion(0).length;
    rope.spans.resize(source.elements.size());
    rope.inertia.resize(source.elements.size(), SpanInertia(0, {.length = 1}));
    for (std::size_t i = 0; i < source.elements.size(); ++i) {
      const ModelElement& element = model.elements[source.elements[i]];
      rope.slots.push_back({layout.position(element.node1), layout.gradient(element.gradient1),
                            layout.position(element.node2), layout.gradient(element.gradient2)});
      place_[source.elements[i]] = {static_cast<std::int32_t>(ropes_.size()), static_cast<std::int32_t>(i)};
      massive_slots_.insert(massive_slots_.end(), rope.slots.back().begin(), rope.slots.back().end());
    }
    longest_ = std::max(longest_, rope.slots.size());
    ropes_.push_back(std::move(rope));
  }
  std::ranges::sort(massive_slots_);
  massive_slots_.erase(std::unique(massive_slots_.begin(), massive_slots_.end()), massive_slots_.end());
}

// First elements of all ropes, second ones, and so on: where ropes meet, what they add comes in the same order in every
// sector of a pocket.
template <typename Function>
void RopeDynamics::for_each_element(const Function& function) const {
  for (std::size_t i = 0; i < longest_; ++i) {
    for (const Rope& rope : ropes_) {
      if (i < rope.slots.size()) function(rope, i);
    }
  }
}

void RopeDynamics::set_motion(const std::function<RopeMotion(double)>& motion) {
  for (Rope& rope : ropes_) rope.motion = motion;
}

void RopeDynamics::update(double t, ElementBatch& batch, std::span<double> mass) {
  const auto same = [](const Rope& a, const Rope& b, std::size_t i) {
    return a.section.mass_per_length == b.section.mass_per_length && a.spans[i] == b.spans[i];
  };
  for (std::size_t r = 0; r < ropes_.size(); ++r) {
    Rope& rope = ropes_[r];
    rope.now = rope.motion(t);
    const double count = static_cast<double>(rope.elements.size());
    // Node i is at p = p1 + (p2 - p1) i / count with p1 = share_at_start (L0 - L).
    const auto node_rate = [&](double i, double rate) { return rate * (i / count - rope.share_at_start); };
    for (std::size_t i = 0; i < rope.elements.size(); ++i) {
      rope.spans[i] = {rope.now.length / count, node_rate(i, rope.now.rate), node_rate(i + 1, rope.now.rate),
                       node_rate(i, rope.now.acceleration), node_rate(i + 1, rope.now.acceleration)};
      // Ropes that move alike share the matrices: their integration is the costly part.
      const bool repeated = r > 0 && i < ropes_[r - 1].spans.size() && same(rope, ropes_[r - 1], i);
      rope.inertia[i] = repeated ? ropes_[r - 1].inertia[i] : SpanInertia(rope.section.mass_per_length, rope.spans[i]);
      batch.set_length(rope.elements[i], rope.spans[i].length, rope.spans[i].length_rate());
    }
  }
  for_each_element([&](const Rope& rope, std::size_t i) {
    const NodalWeights lump = lumped_mass(rope.section.mass_per_length, rope.spans[i].length);
    for (int corner = 0; corner < 4; ++corner) mass[rope.slots[i][corner]] += lump[corner];
  });
  const auto wound = [](const Rope& rope) {
    return rope.section.mass_per_length * (rope.initial_length - rope.now.length);
  };
  for (const Rope& rope : ropes_) mass[rope.slots.front()[0]] += rope.share_at_start * wound(rope);
  for (const Rope& rope : ropes_) mass[rope.slots.back()[2]] += (1 - rope.share_at_start) * wound(rope);
}

void RopeDynamics::add_flow_forces(const SlotVectors& coordinates, const SlotVectors& velocities,
                                   SlotVectors& applied) const {
  for_each_element([&](const Rope& rope, std::size_t i) {
    const ElementCoordinates flow =
        rope.inertia[i].flow_force(gather(coordinates, rope.slots[i]), gather(velocities, rope.slots[i]));
    for (int corner = 0; corner < 4; ++corner) applied.add(rope.slots[i][corner], -flow.col(corner));
  });
  // Material that reaches a retractor gives it its momentum relative to the node: (dm/dt) (u - v) with
  // u - v = -r' dp/dt and dm/dt = rhoA dp/dt at the start, -rhoA dp/dt at the end.
  for (const Rope& rope : ropes_) {
    const double rate = rope.spans.front().start_rate;
    const auto& first = rope.slots.front();
    applied.add(first[0], -rope.section.mass_per_length * rate * rate * coordinates.get(first[1]));
  }
  for (const Rope& rope : ropes_) {
    const double rate = rope.spans.back().end_rate;
    const auto& last = rope.slots.back();
    applied.add(last[2], rope.section.mass_per_length * rate * rate * coordinates.get(last[3]));
  }
}

double RopeDynamics::feeding_power(const SlotVectors& coordinates, const SlotVectors& velocities) const {
  double power = 0;
  for (const Rope& rope : ropes_) {
    for (std::size_t i = 0; i < rope.slots.size(); ++i) {
      const MeanStrainElement element(rope.section, rope.spans[i]);
      power += element.feeding_power(gather(coordinates, rope.slots[i]), gather(velocities, rope.slots[i]));
    }
  }
  return power;
}

const MaterialSpan* RopeDynamics::span_of(std::int32_t element) const {
  const auto [rope, index] = place_[element];
  return rope < 0 ? nullptr : &ropes_[rope].spans[index];
}

}  // namespace netpocket
