#include "engine/dynamics/ropes/ring_ropes.h"

#include <algorithm>
#include <cmath>

#include "engine/math/elementary.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

Eigen::Vector3d chord(const std::vector<std::int32_t>& places, std::size_t part, const CoordinateVectors& coordinates) {
  return coordinates.get(places[part + 1]) - coordinates.get(places[part]);
}

}  // namespace

RingRopes::RingRopes(const Model& model, const CoordinateLayout& layout) {
  for (const RingRope& source : model.ring_ropes) {
    Rope rope{.places = {},
              .parts = {},
              .law = {source.stiffness, source.damping, source.drag, source.least_part},
              .friction = source.friction,
              .extra_angle = source.extra_angle,
              .share_at_start = source.share_at_start,
              .now = source.motion};
    for (const std::int32_t node : source.nodes) rope.places.push_back(layout.position(node));
    double sum = 0;
    for (const double length : source.lengths) sum += length;
    rope.now.length = sum;
    for (const double length : source.lengths) rope.parts.push_back({.length = length});
    ropes_.push_back(std::move(rope));
  }
}

void RingRopes::stretch(const CoordinateVectors& coordinates) {
  for (Rope& rope : ropes_) {
    for (std::size_t i = 0; i < rope.parts.size(); ++i) {
      Part& part = rope.parts[i];
      const double distance = symmetric_norm(chord(rope.places, i, coordinates));
      part.strain = ring_part_strain(distance, part.length);
      part.tension = ring_part_tension(rope.law, {distance, part.length, part.strain}, part.length, 0);
    }
  }
}

double RingRopes::damper_tension(const Rope& rope, const Part& part) {
  return part.tension - rope.law.stiffness * part.strain;
}

// N of ring_ropes.h, with what holds a part that is as short as the rings allow.
double RingRopes::flow_tension(const Rope& rope, const Part& part) {
  const double elastic = rope.law.stiffness * part.strain;
  const double held = rope.law.stiffness * std::max(rope.law.least - part.length, 0.0) / rope.law.least;
  return elastic * (1 + 0.5 * part.strain) + damper_tension(rope, part) * (1 + part.strain) + held;
}

// The angle by which a rope turns at each ring, and the capstan's ratio there.
void RingRopes::find_ratios(const Rope& rope, const CoordinateVectors& coordinates) {
  ratios_.assign(rope.parts.size() - 1, 1.0);
  const bool is_slack = std::ranges::all_of(
      stretched_, [](const RingPart& part) { return part.distance <= part.length && part.strain_before == 0; });
  if (rope.friction == 0 || is_slack) return;  // nothing slides either way
  Eigen::Vector3d last = chord(rope.places, 0, coordinates);
  for (std::size_t ring = 0; ring < ratios_.size(); ++ring) {
    const Eigen::Vector3d next = chord(rope.places, ring + 1, coordinates);
    const double turn = arc_tangent(symmetric_norm(last.cross(next)), symmetric_dot(last, next));
    ratios_[ring] = capstan_ratio(rope.friction, rope.extra_angle + turn);
    last = next;
  }
}

RingRopes::Work RingRopes::advance(Rope& rope, const CoordinateVectors& coordinates, double dt) {
  const RopeMotion& now = rope.now;
  const RopeMotion kept = {now.length + dt * (now.rate + 0.5 * dt * now.acceleration), now.rate + dt * now.acceleration,
                           now.acceleration};
  const RopeMotion next = rope.next.value_or(kept);
  rope.next.reset();
  const double wound = now.length - next.length;
  const double at_start = rope.share_at_start * wound, at_end = wound - at_start;
  rope.now = next;

  before_ = rope.parts;
  rope.parts.front().length -= at_start;
  rope.parts.back().length -= at_end;
  stretched_.clear();
  for (std::size_t i = 0; i < rope.parts.size(); ++i) {
    stretched_.push_back(
        {symmetric_norm(chord(rope.places, i, coordinates)), rope.parts[i].length, rope.parts[i].strain});
  }
  find_ratios(rope, coordinates);
  const std::span<const double> flow = flow_.find(rope.law, stretched_, ratios_, dt);
  for (std::size_t ring = 0; ring < flow.size(); ++ring) {
    rope.parts[ring].length -= flow[ring];
    rope.parts[ring + 1].length += flow[ring];
  }

  Work work;
  for (std::size_t i = 0; i < rope.parts.size(); ++i) {
    Part& part = rope.parts[i];
    part.tension = ring_part_tension(rope.law, stretched_[i], part.length, dt);
    part.strain = ring_part_strain(stretched_[i].distance, std::max(part.length, 0.5 * rope.law.least));
    const double mean = 0.5 * (damper_tension(rope, before_[i]) + damper_tension(rope, part));
    work.in_dampers += std::max(mean * part.length * (part.strain - before_[i].strain), 0.0);
  }
  const auto mean_flow_tension = [&](std::size_t i) {
    return 0.5 * (flow_tension(rope, before_[i]) + flow_tension(rope, rope.parts[i]));
  };
  for (std::size_t ring = 0; ring < flow.size(); ++ring) {
    if (flow[ring] == 0) continue;
    work.at_rings += std::max((mean_flow_tension(ring + 1) - mean_flow_tension(ring)) * flow[ring], 0.0);
  }
  if (wound != 0) {
    work.input = at_start * mean_flow_tension(0) + at_end * mean_flow_tension(rope.parts.size() - 1);
  }
  return work;
}

RingRopes::Work RingRopes::advance(const CoordinateVectors& coordinates, double dt) {
  Work sum;
  for (Rope& rope : ropes_) {
    const Work own = advance(rope, coordinates, dt);
    sum.input += own.input;
    sum.in_dampers += own.in_dampers;
    sum.at_rings += own.at_rings;
  }
  return sum;
}

void RingRopes::add_forces(const CoordinateVectors& coordinates, AppliedForces& applied) const {
  for (const Rope& rope : ropes_) {
    for (std::size_t i = 0; i < rope.parts.size(); ++i) {
      if (rope.parts[i].tension == 0) continue;
      const Eigen::Vector3d along = chord(rope.places, i, coordinates);
      const Eigen::Vector3d pull = rope.parts[i].tension / symmetric_norm(along) * along;
      applied.add(rope.places[i], pull);
      applied.add(rope.places[i + 1], -pull);
    }
  }
}

double RingRopes::energy() const {
  double energy = 0;
  for (const Rope& rope : ropes_) {
    for (const Part& part : rope.parts) {
      const double shortage = std::max(rope.law.least - part.length, 0.0);
      energy += 0.5 * rope.law.stiffness * part.length * part.strain * part.strain +
                0.5 * rope.law.stiffness / rope.law.least * shortage * shortage;
    }
  }
  return energy;
}

double RingRopes::tension(std::size_t rope) const {
  const std::vector<Part>& parts = ropes_[rope].parts;
  return 0.5 * (parts.front().tension + parts.back().tension);
}

std::vector<double> RingRopes::lengths(std::size_t rope) const {
  std::vector<double> lengths;
  for (const Part& part : ropes_[rope].parts) lengths.push_back(part.length);
  return lengths;
}

std::vector<double> RingRopes::tensions(std::size_t rope) const {
  std::vector<double> tensions;
  for (const Part& part : ropes_[rope].parts) tensions.push_back(part.tension);
  return tensions;
}

void RingRopes::visit_state(const std::function<void(double&)>& visit) {
  for (Rope& rope : ropes_) {
    for (Part& part : rope.parts) {
      for (double* number : {&part.length, &part.strain, &part.tension}) visit(*number);
    }
    for (double* number : {&rope.now.length, &rope.now.rate, &rope.now.acceleration}) visit(*number);
  }
}

}  // namespace netpocket
