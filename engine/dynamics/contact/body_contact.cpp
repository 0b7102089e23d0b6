#include "engine/dynamics/contact/body_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/balanced_sum.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

Placement placement(const DynamicBody& body) { return {body.centre(), body.rigid().rotation()}; }

// Velocity of a body's point at `arm` from its centre of mass.
Vector3d velocity_of(const RigidBody& body, const Vector3d& arm) {
  return body.velocity() + body.angular_velocity().cross(arm);
}

// Change of this velocity by an impulse on the body.
Vector3d change_at(const DynamicBody& body, const BodyControl& control, const Wrench& impulse, const Vector3d& arm) {
  const DynamicBody::Motion motion = body.response(impulse, control);
  return motion.velocity + motion.spin.cross(arm);
}

// 1/kg, of the body's point at `arm` along a unit `direction`.
double inverse_mass_at(const DynamicBody& body, const BodyControl& control, const Vector3d& arm,
                       const Vector3d& direction) {
  return symmetric_dot(direction, change_at(body, control, {direction, arm.cross(direction)}, arm));
}

Vector3d across(const Vector3d& vector, const Vector3d& normal) {
  return vector - symmetric_dot(vector, normal) * normal;
}

}  // namespace

BodyContact::BodyContact(const Model& model, std::span<const DynamicBody> bodies)
    : settings_(model.contact), damping_(restitution_damping(model.contact.restitution)) {
  shapes_.reserve(bodies.size());
  for (const ModelBody& body : model.bodies) shapes_.emplace_back(body.shape);
  force_.assign(bodies.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const ModelBody &a = model.bodies[i], &b = model.bodies[j];
      const auto first = static_cast<std::int32_t>(i), second = static_cast<std::int32_t>(j);
      const auto joins = [&](const BodyLock& lock) {
        return std::min(lock.carrier, lock.carried) == first && std::max(lock.carrier, lock.carried) == second;
      };
      if (std::ranges::any_of(model.locks, joins)) continue;  // they may overlap where they are locked
      const double modulus =
          effective_modulus({a.youngs_modulus, a.poisson_ratio}, {b.youngs_modulus, b.poisson_ratio});
      const double radius = effective_radius(contact_radius(a.shape), contact_radius(b.shape));
      pairs_.push_back({first, second, ShapePair(shapes_[i], shapes_[j]), hertz_stiffness(modulus, radius),
                        effective_mass(bodies[i].least_mass(), bodies[j].least_mass())});
    }
  }
}

double BodyContact::stiffness_of(const Pair& pair, double dt) {
  if (pair.stiffness > 0) return pair.stiffness;
  return std::min(pair.material_stiffness, resolved_stiffness(pair.least_mass, 2 * dt));
}

void BodyContact::fix_stiffness(double dt) {
  for (Pair& pair : pairs_) pair.stiffness = stiffness_of(pair, dt);
}

void BodyContact::find(std::span<const DynamicBody> bodies) {
  places_.clear();
  for (Pair& pair : pairs_) {
    pair.shapes.find(placement(bodies[pair.first]), placement(bodies[pair.second]), touches_);
    const Vector3d &first = bodies[pair.first].rigid().position(), &second = bodies[pair.second].rigid().position();
    for (const Touch& touch : touches_) {
      places_.push_back({&pair, touch, touch.point - first, touch.point - second});
    }
  }
}

// Sums, by body, the places' forces on their first bodies and the opposite forces on the second ones.
template <typename Force>
std::vector<Wrench> BodyContact::sum_by_body(const Force& force) const {
  std::vector<std::vector<Vector3d>> forces(force_.size()), torques(force_.size());
  for (const Place& place : places_) {
    const Vector3d on_first = force(place);
    forces[place.pair->first].push_back(on_first);
    torques[place.pair->first].emplace_back(place.first_arm.cross(on_first));
    forces[place.pair->second].emplace_back(-on_first);
    torques[place.pair->second].emplace_back(-place.second_arm.cross(on_first));
  }
  std::vector<Wrench> sums(force_.size());
  for (std::size_t b = 0; b < sums.size(); ++b) sums[b] = {balanced_sum(forces[b]), balanced_sum(torques[b])};
  return sums;
}

// By place, an upper bound (1/kg) of the change of its speed by unit impulses at all places along their directions. It
// follows from W_ij <= sqrt(W_ii W_jj) for each body.
template <typename Direction>
std::vector<double> BodyContact::shared_inverse_masses(const Step& step, const Direction& direction) const {
  std::vector<std::array<double, 2>> roots(places_.size());
  std::vector<std::vector<double>> by_body(step.bodies.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto add = [&](std::size_t side, std::int32_t body, const Vector3d& arm) {
      roots[i][side] = std::sqrt(inverse_mass_at(step.bodies[body], step.controls[body], arm, direction(i)));
      by_body[body].push_back(roots[i][side]);
    };
    add(0, places_[i].pair->first, places_[i].first_arm);
    add(1, places_[i].pair->second, places_[i].second_arm);
  }
  std::vector<double> sums;
  for (std::vector<double>& terms : by_body) sums.push_back(balanced_sum(terms));
  std::vector<double> shared(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Pair& pair = *places_[i].pair;
    shared[i] = roots[i][0] * sums[pair.first] + roots[i][1] * sums[pair.second];
  }
  return shared;
}

std::vector<RigidBody> BodyContact::after(const Step& step, std::span<const Wrench> wrenches) const {
  std::vector<RigidBody> result;
  for (std::size_t b = 0; b < step.bodies.size(); ++b) {
    result.push_back(step.bodies[b].after(wrenches[b], step.controls[b], step.times.kick));
  }
  return result;
}

// Velocity (m/s) of the first body relative to the second at a place.
Vector3d BodyContact::relative_velocity(const Place& place, const RigidBody& first, const RigidBody& second) {
  return velocity_of(first, place.first_arm) - velocity_of(second, place.second_arm);
}

void BodyContact::set_normal_forces(const Step& step, std::span<const Wrench> others) {
  const std::vector<Wrench> springs =
      sum_by_body([](const Place& place) -> Vector3d { return place.elastic * place.touch.normal; });
  const std::vector<RigidBody> later = after(step, others);
  std::vector<double> shared;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    Place& place = places_[i];
    const auto [first, second] = std::pair(place.pair->first, place.pair->second);
    const Vector3d& normal = place.touch.normal;
    const double own = inverse_mass_at(step.bodies[first], step.controls[first], place.first_arm, normal) +
                       inverse_mass_at(step.bodies[second], step.controls[second], place.second_arm, normal);
    if (!(own > 0 && place.elastic > 0)) continue;  // neither body can move, or no spring force is left
    const Vector3d change = change_at(step.bodies[first], step.controls[first], springs[first], place.first_arm) -
                            change_at(step.bodies[second], step.controls[second], springs[second], place.second_arm);
    const double together = symmetric_dot(normal, change) / place.elastic;
    double inverse_mass = std::max(together, own / static_cast<double>(places_.size()));
    const double root = std::sqrt(place.touch.depth);
    const NormalLaw law{place.stiffness, damping_ * std::sqrt(place.stiffness / inverse_mass)};
    if (1.5 * place.stiffness * root * inverse_mass * step.times.kick * step.times.drift > 1) {
      if (shared.empty()) shared = shared_inverse_masses(step, [&](std::size_t j) { return places_[j].touch.normal; });
      inverse_mass = shared[i];
    }
    const Vector3d before = relative_velocity(place, step.bodies[first].rigid(), step.bodies[second].rigid());
    const StepSpeeds speeds{symmetric_dot(normal, before),
                            symmetric_dot(normal, relative_velocity(place, later[first], later[second]))};
    place.normal = stepped_normal_force(law, place.touch.depth, speeds, step.times.inertia_factor() * inverse_mass,
                                        step.times.drift);
  }
}

// Computed after the normal forces, which may change the sliding. Friction opposes the mean of the sliding velocities
// before and after the step.
void BodyContact::set_friction_forces(const Step& step, std::span<const Wrench> others) {
  if (settings_.friction <= 0) return;
  std::vector<Wrench> wrenches =
      sum_by_body([](const Place& place) -> Vector3d { return place.normal * place.touch.normal; });
  for (std::size_t b = 0; b < wrenches.size(); ++b) wrenches[b] += others[b];
  const std::vector<RigidBody> later = after(step, wrenches);
  std::vector<Vector3d> sliding, direction;
  for (const Place& place : places_) {
    const auto [first, second] = std::pair(place.pair->first, place.pair->second);
    const Vector3d mean = 0.5 * (relative_velocity(place, step.bodies[first].rigid(), step.bodies[second].rigid()) +
                                 relative_velocity(place, later[first], later[second]));
    sliding.push_back(across(mean, place.touch.normal));
    const double speed = symmetric_norm(sliding.back());
    direction.push_back(speed > 0 ? Vector3d(sliding.back() / speed) : Vector3d::Zero());
  }
  const std::vector<double> shared = shared_inverse_masses(step, [&](std::size_t i) { return direction[i]; });
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!(shared[i] > 0)) continue;
    places_[i].friction =
        -sliding_resistance(settings_.friction, settings_.friction_velocity, places_[i].normal,
                            symmetric_norm(sliding[i]), step.times.inertia_factor() * shared[i], step.times.drift) *
        sliding[i];
  }
}

void BodyContact::add_forces(std::span<const DynamicBody> bodies, std::span<const BodyControl> controls,
                             const StepTimes& times, std::vector<Wrench>& wrenches) {
  std::ranges::fill(force_, Vector3d::Zero());
  if (places_.empty()) return;
  for (Place& place : places_) {
    place.stiffness = place.touch.weight * stiffness_of(*place.pair, times.drift);
    place.elastic = place.stiffness * place.touch.depth * std::sqrt(place.touch.depth);
  }
  const Step step{bodies, controls, times};
  set_normal_forces(step, wrenches);
  set_friction_forces(step, wrenches);
  const std::vector<Wrench> sums = sum_by_body([](const Place& place) { return place.force(); });
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    force_[b] = sums[b].force;
    wrenches[b] += sums[b];
  }
}

double BodyContact::stored_energy() const {
  double energy = 0;
  for (const Place& place : places_) energy += 0.4 * place.elastic * place.touch.depth;
  return energy;
}

BodyContact::Power BodyContact::power(std::span<const DynamicBody> bodies) const {
  Power power;
  for (const Place& place : places_) {
    const Vector3d velocity =
        relative_velocity(place, bodies[place.pair->first].rigid(), bodies[place.pair->second].rigid());
    power.damping += (place.elastic - place.normal) * symmetric_dot(velocity, place.touch.normal);
    power.friction -= symmetric_dot(velocity, place.friction);
  }
  return power;
}

double BodyContact::deepest_penetration() const {
  double deepest = 0;
  for (const Place& place : places_) deepest = std::max(deepest, place.touch.depth);
  return deepest;
}

double BodyContact::total_normal_force() const {
  double sum = 0;
  for (const Place& place : places_) sum += place.normal;
  return sum;
}

void BodyContact::append_points(std::vector<ContactPoint>& points) const {
  for (const Place& place : places_) {
    if (place.normal <= 0) continue;
    points.push_back({place.touch.point, place.force(), -1, place.pair->first});
    points.push_back({place.touch.point, -place.force(), -1, place.pair->second});
  }
}

void BodyContact::visit_state(const std::function<void(double&)>& visit) {
  for (Pair& pair : pairs_) visit(pair.stiffness);
}

}  // namespace netpocket
