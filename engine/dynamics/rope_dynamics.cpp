#include "engine/dynamics/rope_dynamics.h"

#include <algorithm>
#include <array>

#include "engine/ancf/mass.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/variable_length.h"

namespace netpocket {
namespace {

// Ropes that are computed at once.
constexpr std::size_t kLanes = 8;

// Coordinates or velocities of the elements in the same place of several ropes: [corner][axis], one lane per rope.
using RopeLanes = Eigen::Array<double, kLanes, 1>;
using LaneCoordinates = std::array<std::array<RopeLanes, 3>, 4>;

template <typename Ropes>
LaneCoordinates gather(const SlotVectors& vectors, const Ropes& ropes, std::size_t index) {
  LaneCoordinates q;
  for (std::size_t corner = 0; corner < 4; ++corner) {
    for (RopeLanes& lanes : q[corner]) lanes.setZero();
    for (std::size_t lane = 0; lane < ropes.size(); ++lane) {
      const Eigen::Vector3d vector = vectors.get(ropes[lane].slots[index][corner]);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        q[corner][static_cast<std::size_t>(axis)][static_cast<Eigen::Index>(lane)] = vector[axis];
      }
    }
  }
  return q;
}

// Row `corner` of matrix * columns.
RopeLanes product(const Eigen::Matrix4d& matrix, Eigen::Index corner, const LaneCoordinates& q, std::size_t axis) {
  return (matrix(corner, 0) * q[0][axis] + matrix(corner, 1) * q[1][axis]) +
         (matrix(corner, 2) * q[2][axis] + matrix(corner, 3) * q[3][axis]);
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

bool RopeDynamics::set_time(double t) {
  bool changed = !started_;
  started_ = true;
  for (Rope& rope : ropes_) {
    const RopeMotion motion = rope.motion(t);
    changed = changed || !(motion == rope.now);
    rope.now = motion;
  }
  return changed;
}

void RopeDynamics::set_spans(Rope& rope) {
  const double count = static_cast<double>(rope.elements.size());
  // Node i is at p = p1 + (p2 - p1) i / count with p1 = share_at_start (L0 - L).
  const auto node_rate = [&](double i, double rate) { return rate * (i / count - rope.share_at_start); };
  for (std::size_t i = 0; i < rope.elements.size(); ++i) {
    const double place = static_cast<double>(i);
    rope.spans[i] = {rope.now.length / count, node_rate(place, rope.now.rate), node_rate(place + 1, rope.now.rate),
                     node_rate(place, rope.now.acceleration), node_rate(place + 1, rope.now.acceleration)};
  }
}

// Ropes that move alike share the matrices: their integration is the costly part.
void RopeDynamics::set_inertia() {
  for (std::size_t r = 0; r < ropes_.size(); ++r) {
    Rope& rope = ropes_[r];
    const bool as_previous = r > 0 && rope.section.mass_per_length == ropes_[r - 1].section.mass_per_length &&
                             rope.spans == ropes_[r - 1].spans;
    rope.leader = as_previous ? ropes_[r - 1].leader : r;
    if (as_previous) continue;
    for (std::size_t i = 0; i < rope.spans.size(); ++i) {
      rope.inertia[i] = SpanInertia(rope.section.mass_per_length, rope.spans[i]);
    }
  }
}

void RopeDynamics::update(ElementBatch& batch, std::span<double> mass) {
  for (Rope& rope : ropes_) {
    set_spans(rope);
    for (std::size_t i = 0; i < rope.elements.size(); ++i) {
      batch.set_length(rope.elements[i], rope.spans[i].length, rope.spans[i].length_rate());
    }
  }
  flowing_ = std::ranges::any_of(ropes_, [](const Rope& r) { return r.now.rate != 0 || r.now.acceleration != 0; });
  set_inertia();
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

// `alike`: at most kLanes ropes with the same leader.
void RopeDynamics::add_flow_forces(std::span<const Rope> alike, std::size_t index, const SlotVectors& coordinates,
                                   const SlotVectors& velocities, SlotVectors& applied) const {
  const SpanInertia& inertia = ropes_[alike.front().leader].inertia[index];
  const LaneCoordinates q = gather(coordinates, alike, index), velocity = gather(velocities, alike, index);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    std::array<RopeLanes, 3> flow;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<Eigen::Index>(corner);
      flow[axis] =
          2 * product(inertia.mass_velocity, row, velocity, axis) + product(inertia.mass_position, row, q, axis);
    }
    for (std::size_t lane = 0; lane < alike.size(); ++lane) {
      const auto i = static_cast<Eigen::Index>(lane);
      applied.add(alike[lane].slots[index][corner], Eigen::Vector3d(-flow[0][i], -flow[1][i], -flow[2][i]));
    }
  }
}

void RopeDynamics::add_flow_forces(const SlotVectors& coordinates, const SlotVectors& velocities,
                                   SlotVectors& applied) const {
  if (!flowing_) return;
  for (std::size_t i = 0; i < longest_; ++i) {
    for (std::size_t first = 0, last = 0; first < ropes_.size(); first = last) {
      last = first + 1;
      while (last < ropes_.size() && last - first < kLanes && ropes_[last].leader == ropes_[first].leader) ++last;
      if (i < ropes_[first].slots.size()) {
        add_flow_forces(std::span(ropes_).subspan(first, last - first), i, coordinates, velocities, applied);
      }
    }
  }
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

const MaterialSpan* RopeDynamics::span_of(std::int32_t element) const {
  const auto [rope, index] = place_[element];
  return rope < 0 ? nullptr : &ropes_[rope].spans[index];
}

}  // namespace netpocket
