#include "engine/dynamics/ropes/rope_dynamics.h"

#include <algorithm>
#include <array>

#include "engine/ancf/mass.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/ancf/variable_length.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

ElementCoordinates gather(const CoordinateVectors& vectors, const std::array<std::int32_t, 4>& indices) {
  ElementCoordinates columns;
  for (int corner = 0; corner < 4; ++corner) columns.col(corner) = vectors.get(indices[corner]);
  return columns;
}

struct RopeKernels {
  rope_kernel::ForceKernel forces;
  rope_kernel::EnergyKernel energy_change;
  rope_kernel::TensionKernel tensions;
};

const RopeKernels& rope_kernels() {
  static const RopeKernels chosen = {NETPOCKET_VARIANT_OF(rope_kernel, forces),
                                     NETPOCKET_VARIANT_OF(rope_kernel, energy_change),
                                     NETPOCKET_VARIANT_OF(rope_kernel, tensions)};
  return chosen;
}

void set_lane(SpanRows& rows, int lane, const MaterialSpan& span) {
  rows.length[lane] = span.length;
  rows.start_rate[lane] = span.start_rate;
  rows.end_rate[lane] = span.end_rate;
}

}  // namespace

// Node i is at the material coordinate p = p1 + (p2 - p1) i / count with p1 = share_at_start (L0 - L).
MaterialSpan rope_span(const RopeMotion& motion, double share_at_start, std::size_t index, std::size_t count) {
  const double elements = static_cast<double>(count), place = static_cast<double>(index);
  const double first = place / elements - share_at_start, second = (place + 1) / elements - share_at_start;
  return {motion.length / elements, motion.rate * first, motion.rate * second, motion.acceleration * first,
          motion.acceleration * second};
}

RopeDynamics::RopeDynamics(const Model& model, const CoordinateLayout& layout) {
  place_.assign(model.elements.size(), {-1, -1});
  for (const VariableRope& source : model.ropes) {
    Rope rope{.elements = source.elements,
              .section = model.material_of(source.elements.front()).section,
              .share_at_start = source.share_at_start,
              .initial_length = source.motion.length,
              .before = source.motion,
              .now = source.motion,
              .of_spans = source.motion};
    rope.spans.resize(source.elements.size());
    for (std::size_t i = 0; i < source.elements.size(); ++i) {
      const ModelElement& element = model.elements[source.elements[i]];
      rope.indices.push_back({layout.position(element.node1), layout.gradient(element.gradient1),
                              layout.position(element.node2), layout.gradient(element.gradient2)});
      place_[source.elements[i]] = {static_cast<std::int32_t>(ropes_.size()), static_cast<std::int32_t>(i)};
      massive_coordinates_.insert(massive_coordinates_.end(), rope.indices.back().begin(), rope.indices.back().end());
    }
    longest_ = std::max(longest_, rope.indices.size());
    ropes_.push_back(std::move(rope));
  }
  collect_blocks();
  std::ranges::sort(massive_coordinates_);
  massive_coordinates_.erase(std::unique(massive_coordinates_.begin(), massive_coordinates_.end()),
                             massive_coordinates_.end());
}

void RopeDynamics::collect_blocks() {
  for_each_element([&](const Rope& rope, std::size_t i) {
    if (blocks_.empty() || blocks_.back().count == kBlockSize) blocks_.emplace_back();
    RopeBlock& block = blocks_.back();
    const int lane = block.count++;
    block.mass_per_length[lane] = rope.section.mass_per_length;
    block.rope[lane] = static_cast<std::int32_t>(&rope - ropes_.data());
    block.axial_stiffness[lane] = rope.section.EA;
    block.compression[lane] = rope.section.compression;
    block.axial_damping[lane] = rope.section.axial_damping;
    for (int corner = 0; corner < 4; ++corner) block.coordinate[corner][lane] = rope.indices[i][corner];
  });
}

template <typename Function>
void RopeDynamics::for_each_lane(const Function& function) {
  std::size_t place = 0;
  for_each_element([&](const Rope& rope, std::size_t i) {
    function(rope, i, blocks_[place / kBlockSize], static_cast<int>(place % kBlockSize));
    ++place;
  });
}

void RopeDynamics::set_present_spans() {
  for (Rope& rope : ropes_) {
    for (std::size_t i = 0; i < rope.spans.size(); ++i) rope.spans[i] = rope.span_at(rope.now, i);
    rope.of_spans = rope.now;
  }
  for_each_lane(
      [](const Rope& rope, std::size_t i, RopeBlock& block, int lane) { set_lane(block.now, lane, rope.spans[i]); });
}

void RopeDynamics::set_previous_spans() {
  for_each_lane([](const Rope& rope, std::size_t i, RopeBlock& block, int lane) {
    set_lane(block.before, lane, rope.span_at(rope.before, i));
  });
  previous_spans_are_set_ = true;
}

// Visits the first elements of all ropes, then all second ones, and so on. So contributions to nodes where ropes meet
// come in the same order in every sector of a pocket.
template <typename Function>
void RopeDynamics::for_each_element(const Function& function) const {
  for (std::size_t i = 0; i < longest_; ++i) {
    for (const Rope& rope : ropes_) {
      if (i < rope.indices.size()) function(rope, i);
    }
  }
}

// Visits the ends of all ropes, with the coordinate of the position and the share of the wound-up rope that it carries.
// All first ends come before all last ends, for the reason above.
template <typename Function>
void RopeDynamics::for_each_end(const Function& function) const {
  for (const Rope& rope : ropes_) function(rope, rope.indices.front()[0], rope.share_at_start);
  for (const Rope& rope : ropes_) function(rope, rope.indices.back()[2], 1 - rope.share_at_start);
}

bool RopeDynamics::refresh_spans() {
  const bool changed =
      !started_ || std::ranges::any_of(ropes_, [](const Rope& rope) { return !(rope.now == rope.of_spans); });
  started_ = true;
  if (changed) set_present_spans();
  if (!previous_spans_are_set_) set_previous_spans();
  return changed;
}

void RopeDynamics::finish_step(double dt) {
  for (Rope& rope : ropes_) {
    rope.before = rope.now;
    RopeMotion& now = rope.now;
    const RopeMotion kept = {now.length + dt * (now.rate + 0.5 * dt * now.acceleration),
                             now.rate + dt * now.acceleration, now.acceleration};
    now = rope.next.value_or(kept);
    rope.next.reset();
  }
  for (RopeBlock& block : blocks_) block.before = block.now;
}

void RopeDynamics::update(ElementBatch& batch, std::span<double> mass) {
  for (Rope& rope : ropes_) {
    for (std::size_t i = 0; i < rope.elements.size(); ++i) {
      batch.set_length(rope.elements[i], rope.spans[i].length, rope.spans[i].length_rate());
    }
  }
  for_each_element([&](const Rope& rope, std::size_t i) {
    const NodalWeights lump = lumped_mass(rope.section.mass_per_length, rope.spans[i].length);
    for (int corner = 0; corner < 4; ++corner) mass[rope.indices[i][corner]] += lump[corner];
  });
  for_each_end([&](const Rope& rope, std::int32_t coordinate, double share) {
    mass[coordinate] += share * rope.wound_mass(rope.now);
  });
}

void RopeDynamics::add_flow_forces(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                                   double last_dt, double kick, AppliedForces& applied) {
  if (!moves()) return;
  for (RopeBlock& block : blocks_) {
    rope_kernels().forces(coordinates.rows(), velocities.rows(), last_dt, kick, block);
    for (int lane = 0; lane < block.count; ++lane) {
      for (int corner = 0; corner < 4; ++corner) {
        applied.add(block.coordinate[corner][lane], lane_of(block.force[corner], lane));
      }
    }
  }
  for_each_end([&](const Rope& rope, std::int32_t coordinate, double share) {
    const double lost = share * (rope.wound_mass(rope.before) - rope.wound_mass(rope.now));
    applied.add(coordinate, lost / kick * velocities.get(coordinate));
  });
}

double RopeDynamics::energy_change(const CoordinateVectors& coordinates, const CoordinateVectors& velocities) {
  if (!moves()) return 0;
  double change = 0;
  for (RopeBlock& block : blocks_) {
    rope_kernels().energy_change(coordinates.rows(), velocities.rows(), block);
    for (int lane = 0; lane < block.count; ++lane) change += block.energy_change[lane];
  }
  for_each_end([&](const Rope& rope, std::int32_t coordinate, double share) {
    const double gained = share * (rope.wound_mass(rope.now) - rope.wound_mass(rope.before));
    change += 0.5 * gained * squared_norm(velocities.get(coordinate));
  });
  return change;
}

void RopeDynamics::mean_tensions(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                                 std::span<double> tensions) const {
  std::ranges::fill(tensions, 0.0);
  SpanRows spans;
  alignas(64) double of_lanes[kBlockSize];
  std::size_t place = 0;
  const auto end_block = [&](const RopeBlock& block) {
    rope_kernels().tensions(coordinates.rows(), velocities.rows(), spans, block, of_lanes);
    for (int lane = 0; lane < block.count; ++lane) {
      const auto rope = static_cast<std::size_t>(block.rope[lane]);
      if (rope < tensions.size()) tensions[rope] += of_lanes[lane] / static_cast<double>(ropes_[rope].elements.size());
    }
  };
  for_each_element([&](const Rope& rope, std::size_t i) {
    const RopeBlock& block = blocks_[place / kBlockSize];
    const int lane = static_cast<int>(place % kBlockSize);
    set_lane(spans, lane, rope.span_at(rope.now, i));
    if (lane + 1 == block.count) end_block(block);
    ++place;
  });
}

RopeDynamics::FlowEnergy RopeDynamics::flow_energy(const CoordinateVectors& coordinates,
                                                   const CoordinateVectors& velocities) const {
  FlowEnergy energy;
  for_each_element([&](const Rope& rope, std::size_t i) {
    const double mass = rope.section.mass_per_length;
    const ElementCoordinates q = gather(coordinates, rope.indices[i]), velocity = gather(velocities, rope.indices[i]);
    const MaterialSpan at_rest{.length = rope.spans[i].length};
    energy.kinetic += kinetic_energy(mass, rope.spans[i], q, velocity) - kinetic_energy(mass, at_rest, q, velocity);
    energy.work += flow_work(mass, rope.spans[i], q, velocity);
  });
  return energy;
}

void RopeDynamics::visit_state(const std::function<void(double&)>& visit) {
  for (Rope& rope : ropes_) {
    for (double* number :
         {&rope.before.length, &rope.before.rate, &rope.now.length, &rope.now.rate, &rope.now.acceleration}) {
      visit(*number);
    }
  }
  previous_spans_are_set_ = false;
}

void RopeDynamics::take_motions(const RopeDynamics& from, std::size_t per_rope, std::size_t stride) {
  for (std::size_t i = 0; i < ropes_.size(); ++i) {
    const Rope& source = from.ropes_[i / per_rope * stride];
    ropes_[i].before = source.before;
    ropes_[i].now = source.now;
    ropes_[i].next = source.next;
  }
  previous_spans_are_set_ = false;
}

const MaterialSpan* RopeDynamics::span_of(std::int32_t element) const {
  const auto [rope, index] = place_[element];
  return rope < 0 ? nullptr : &ropes_[rope].spans[index];
}

}  // namespace netpocket
