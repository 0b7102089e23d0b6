#include "engine/dynamics/contact/contact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/dynamics/contact/contact_blocks.h"
#include "engine/dynamics/contact/contact_stop.h"
#include "engine/dynamics/contact/cord_chain.h"
#include "engine/math/instruction_set.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// A search ahead is needed only if kGrowingWay times the distance of a step exceeds this many radii of the thinnest
// cord. Otherwise a cord is found before it is deeper than its radius.
constexpr double kShortWay = 2;
// Factor on the distance of a step at the present speed, as an allowance for acceleration.
constexpr double kGrowingWay = 2;
// Springs become softer again when a step exceeds the one they are for by this factor. They resolve longer ones too.
constexpr double kLongStep = 0.7;
// Springs become stiffer when a step is below this part of the one they are for.
constexpr double kShortStep = 0.25;

// Springs that bear more than kMuchLoad of what the softest ones bear at their greatest compression are to be resolved
// by steps half as long. Springs below it store less than a third of that energy, which grows with the load to the
// power 5/3.
constexpr double kMuchLoad = 0.5, kFinerPhase = 4;

struct ForceKernels {
  contact_kernel::ForceKernel forces;
  contact_kernel::PowerKernel power;
};

const ForceKernels& force_kernels() {
  using namespace contact_kernel;
  static const ForceKernels chosen = {NETPOCKET_VARIANT_OF(contact_kernel, forces),
                                      NETPOCKET_VARIANT_OF(contact_kernel, power)};
  return chosen;
}

void copy(const Vector3d& vector, double* out) { std::copy_n(vector.data(), 3, out); }

contact_kernel::BodyMotion motion_of(const DynamicBody& body, double shares) {
  contact_kernel::BodyMotion motion{};
  copy(body.rigid().position(), motion.position);
  copy(body.rigid().velocity(), motion.velocity);
  copy(body.rigid().angular_velocity(), motion.angular_velocity);
  motion.inverse_mass = body.inverse_mass();
  for (int axis = 0; axis < 3; ++axis) {
    copy(body.rigid().apply_inverse_inertia(Vector3d::Unit(axis)), motion.inverse_inertia[axis]);
  }
  motion.largest_inverse_inertia = body.largest_inverse_inertia();
  motion.contacts = shares;
  return motion;
}

}  // namespace

ContactSolver::ContactSolver(const Model& model, const CoordinateLayout& layout)
    : model_(model),
      polyline_(model, layout),
      settings_(model.contact),
      body_force_(model.bodies.size(), Vector3d::Zero()) {
  const std::vector<std::int32_t> next = next_elements(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    ContactSearch search(model, next, static_cast<std::int32_t>(b));
    ContactLaws laws(model, static_cast<std::int32_t>(b), search);
    SpringOffsets offsets(search.parts().size(), search.holders().count());
    partners_.push_back({.search = std::move(search), .laws = std::move(laws), .offsets = std::move(offsets)});
  }
}

void ContactSolver::forget_candidates() {
  for (Partner& partner : partners_) partner.search.forget();
}

void ContactSolver::set_reference_step(double dt) {
  steps_ = {dt, dt};
  for (Partner& partner : partners_) {
    partner.laws.set_steps(steps_);
    partner.offsets.clear();
  }
}

void ContactSolver::note_motion(double cords, std::span<const double> bodies) {
  for (std::size_t b = 0; b < partners_.size(); ++b) {
    partners_[b].way = cords + bodies[b];
    partners_[b].search.note_way(partners_[b].way);
  }
}

// Shape functions at the place of a touch on an element of `length` (m).
ElementWeights ContactSolver::weights_at(const CordTouch& touch, double length) const {
  const ElementWeights start = polyline_.weights(touch.segment, length);
  const ElementWeights end = polyline_.weights(touch.segment + 1, length);
  ElementWeights weights{};
  for (std::size_t i = 0; i < 4; ++i) weights[i] = (1 - touch.t) * start[i] + touch.t * end[i];
  return weights;
}

void ContactSolver::note_depth(std::int32_t body, double body_mass, std::int32_t element, std::int32_t part,
                               bool is_cord_end, double penetration) {
  deepest_penetration_ = std::max(deepest_penetration_, penetration);
  Partner& partner = partners_[static_cast<std::size_t>(body)];
  const double radius = partner.search.radius_of(element);
  constexpr double kRounding = 1 - 1e-12;
  if (penetration <= kRounding * deepest_part_.part * radius) return;  // saves most divisions
  const double of_radius = penetration / radius;
  if (of_radius <= deepest_part_.part) return;
  deepest_part_ = {of_radius, element, body, partner.laws.of(element, part, is_cord_end, body_mass).softening};
}

// As note_depth for each contact. A block in which nothing can be deeper than before is passed over.
void ContactSolver::note_depths(std::int32_t body, double body_mass, const TouchBlock& touch,
                                const ContactBlock& block) {
  const ContactSearch& search = partners_[static_cast<std::size_t>(body)].search;
  double largest = 0;
  for (const double depth : block.penetration) largest = depth > largest ? depth : largest;
  if (largest <= deepest_penetration_ && largest <= 0.99 * deepest_part_.part * search.smallest_radius()) return;
  for_each_lane(block, [&](int lane) {
    note_depth(body, body_mass, touch.element[lane], 0, block.is_cord_end[lane], block.penetration[lane]);
  });
}

void ContactSolver::add_contact(std::int32_t body, double body_mass, const CordTouch& touch, double length,
                                std::int32_t place) {
  Partner& partner = partners_[static_cast<std::size_t>(body)];
  ContactBlock& block = contacts_[static_cast<std::size_t>(place / kBlockSize)];
  const int lane = place % kBlockSize;
  const ElementWeights weights = weights_at(touch, length);
  const ElementIndices indices = polyline_.indices(touch.element);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    block.weight[corner][lane] = weights[corner];
    block.coordinate[corner][lane] = indices[corner];
  }
  for (int axis = 0; axis < 3; ++axis) {
    block.point[axis][lane] = touch.point[axis];
    block.normal[axis][lane] = touch.normal[axis];
  }
  const ContactLaw& law = partner.laws.of(touch.element, touch.part, touch.is_cord_end, body_mass);
  block.penetration[lane] = touch.penetration;
  block.stiffness[lane] = law.law.stiffness;
  block.damping[lane] = law.law.damping;
  // A place that takes back what others count twice stops nothing.
  block.deepest[lane] = touch.share < 0 ? std::numeric_limits<double>::infinity() : std::min(law.impact, law.deepest);
  block.share[lane] = touch.share;
  block.is_extra[lane] = touch.is_extra;
  block.element[lane] = touch.element;
  block.part[lane] = touch.part;
  block.holder[lane] = touch.holder;
  block.is_cord_end[lane] = touch.is_cord_end;
  partner.shares += std::abs(touch.share);
}

// Follows the place along its velocity relative to the body, by sphere tracing: it advances by the gap to the body,
// which no point can close sooner.
bool ContactSolver::hits_within_step(const CordTouch& touch, std::int32_t body, double length,
                                     const CoordinateVectors& velocities, const DynamicBody& dynamic, double dt) const {
  const Vector3d velocity = combine(velocities, polyline_.indices(touch.element), weights_at(touch, length)) -
                            dynamic.rigid().velocity_at(touch.point);
  const double speed = symmetric_norm(velocity), radius = model_.radius_of(touch.element);
  if (!(symmetric_dot(velocity, touch.normal) < 0)) return false;
  const ContactPart& part =
      partners_[static_cast<std::size_t>(body)].search.parts()[static_cast<std::size_t>(touch.part)];
  const double least = 0.01 * radius;
  double time = 0, gap = -touch.penetration;
  while (gap > least) {
    time += gap / speed;
    if (time > kGrowingWay * dt) return false;
    const Vector3d there = touch.point + time * velocity - dynamic.centre();
    gap = part.nearest(symmetric_transposed_product(dynamic.rigid().rotation(), there)).distance - radius;
  }
  return true;
}

// Distance (m) from the body within which a cord may touch it in the step, if speeds grow by at most kGrowingWay. 0 if
// no search ahead is needed.
double ContactSolver::way_ahead(std::int32_t body, const DynamicBody& dynamic, double cord_speed, double dt) const {
  const ContactSearch& search = partners_[static_cast<std::size_t>(body)].search;
  const RigidBody& rigid = dynamic.rigid();
  const double centre_speed = symmetric_norm(rigid.velocity_at(dynamic.centre()));
  const double rim_speed = symmetric_norm(rigid.angular_velocity()) * search.bounding_radius();
  const double way = kGrowingWay * dt * (cord_speed + centre_speed + rim_speed);
  return way > kShortWay * search.smallest_radius() ? way : 0;
}

void ContactSolver::find_contacts(std::int32_t body, const CoordinateVectors& coordinates,
                                  const CoordinateVectors& velocities, const ElementBatch& batch,
                                  const DynamicBody& dynamic, double cord_speed, double dt) {
  Partner& partner = partners_[static_cast<std::size_t>(body)];
  partner.first = partner.last = contacts_.size();
  partner.first_place = partner.last_place = places_.size();
  partner.shares = 0;
  if (!is_sound(Eigen::AlignedBox3d(dynamic.centre()))) return;
  partner.search.find(coordinates, batch, dynamic, way_ahead(body, dynamic, cord_speed, dt), touches_);
  std::erase_if(touches_, [&](const CordTouch& touch) {
    const double length = batch.block(touch.element / kBlockSize).length[touch.element % kBlockSize];
    return !(touch.penetration > 0) && !hits_within_step(touch, body, length, velocities, dynamic, dt);
  });
  add_touches(body, dynamic.least_mass(), batch);
  add_sphere_touches(body, dynamic.least_mass(), batch);
  partner.last = contacts_.size();
  partner.last_place = places_.size();
  if (!partner.offsets.are_zero()) apply_offsets(partner, dynamic.least_mass());
}

void ContactSolver::add_touches(std::int32_t body, double body_mass, const ElementBatch& batch) {
  const std::size_t first_place = places_.size();
  lay_out(touches_, body, contacts_, places_);
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const CordTouch& touch = touches_[i];
    if (touch.penetration > 0) {
      note_depth(body, body_mass, touch.element, touch.part, touch.is_cord_end, touch.penetration);
    }
    const double length = batch.block(touch.element / kBlockSize).length[touch.element % kBlockSize];
    add_contact(body, body_mass, touch, length, places_[first_place + i]);
  }
}

void ContactSolver::add_sphere_touches(std::int32_t body, double body_mass, const ElementBatch& batch) {
  Partner& partner = partners_[static_cast<std::size_t>(body)];
  const std::span<const TouchBlock> touches = partner.search.sphere_touches().blocks();
  for (std::size_t i = 0; i < touches.size();) {
    const std::size_t first_block = contacts_.size();
    for (const std::int32_t elements = touches[i].block; i < touches.size() && touches[i].block == elements; ++i) {
      ContactBlock& block = contacts_.append();
      place_touches(touches[i], body, partner.search, body_mass, batch, partner.laws, block);
      note_depths(body, body_mass, touches[i], block);
    }
    list_places(first_block);
  }
  for (std::size_t place = partner.first_place; place < places_.size() && !touches.empty(); ++place) {
    partner.shares +=
        contacts_[static_cast<std::size_t>(places_[place] / kBlockSize)].share[places_[place] % kBlockSize];
  }
}

// Lists the contacts of the blocks from `first_block` on, which are of the same elements: element by element.
void ContactSolver::list_places(std::size_t first_block) {
  for (int lane = 0; lane < kBlockSize; ++lane) {
    for (std::size_t block = first_block; block < contacts_.size(); ++block) {
      if ((contacts_[block].used >> lane & 1U) == 0) continue;
      places_.push_back(static_cast<std::int32_t>(block) * kBlockSize + lane);
    }
  }
}

bool ContactSolver::are_springs_plain() const {
  return steps_.present == steps_.reference &&
         std::ranges::all_of(partners_, [](const Partner& partner) { return partner.offsets.are_zero(); });
}

// Springs begin at their offsets. The springs of a holder have one offset, which is at most their greatest depth. The
// offsets of holders that touch no more are forgotten.
void ContactSolver::apply_offsets(Partner& partner, double body_mass) {
  std::map<SpringOffsets::Place, double> deepest;  // then their offsets
  const auto for_each_of_partner = [&](const auto& function) {
    for (std::size_t i = partner.first; i < partner.last; ++i) {
      ContactBlock& block = contacts_[i];
      for_each_lane(
          block, [&](int lane) { function(block, lane, SpringOffsets::Place(block.part[lane], block.holder[lane])); });
    }
  };
  for_each_of_partner([&](const ContactBlock& block, int lane, const SpringOffsets::Place& place) {
    double& depth = deepest[place];
    depth = std::max(depth, block.penetration[lane]);
  });
  for (auto& [place, depth] : deepest) {
    depth = partner.offsets.follow(place, depth, partner.search.holders().neighbours(place.second), partner.way);
  }
  for_each_of_partner([&](ContactBlock& block, int lane, const SpringOffsets::Place& place) {
    const double depth = block.penetration[lane], offset = std::min(deepest[place], std::max(depth, 0.0));
    const ContactLaw& law = partner.laws.of(block.element[lane], block.part[lane], block.is_cord_end[lane], body_mass);
    block.penetration[lane] = depth - offset;
    block.offset[lane] = offset;
    if (block.share[lane] > 0) block.deepest[lane] = std::min(law.impact, law.deepest - offset);
  });
  partner.offsets.end_step();
}

double ContactSolver::stiffness_step_for(double dt) const {
  constexpr int kMostHalvings = 7;  // stiffer springs are those of the materials
  const double shortest = std::ldexp(steps_.reference, -kMostHalvings);
  double step = steps_.present;
  while (dt <= kShortStep * step && step > shortest) step *= 0.5;
  while (dt > kLongStep * step && step < steps_.reference) step *= 2;
  return step;
}

// The springs of each holder keep the energy that they store together.
void ContactSolver::fit_stiffness(double dt, const std::vector<DynamicBody>& bodies) {
  steps_.present = stiffness_step_for(dt);
  for (std::size_t b = 0; b < partners_.size(); ++b) {
    Partner& partner = partners_[b];
    partner.laws.set_steps(steps_);
    std::map<SpringOffsets::Place, std::vector<ChangingSpring>> holders;
    for (const std::int32_t place : places_of(partner)) {
      const ContactBlock& block = contacts_[static_cast<std::size_t>(place / kBlockSize)];
      const int lane = place % kBlockSize;
      const double next =
          partner.laws.of(block.element[lane], block.part[lane], block.is_cord_end[lane], bodies[b].least_mass())
              .law.stiffness;
      holders[{block.part[lane], block.holder[lane]}].push_back({block.share[lane],
                                                                 block.penetration[lane] + block.offset[lane],
                                                                 block.penetration[lane], block.stiffness[lane], next});
    }
    std::vector<std::pair<SpringOffsets::Place, double>> offsets;
    for (const auto& [place, springs] : holders) offsets.emplace_back(place, offset_of_same_energy(springs));
    partner.offsets.set(offsets);
  }
}

void ContactSolver::visit_state(const std::function<void(double&)>& visit) {
  double step = steps_.present;
  visit(step);
  // A file may hold a number that is not a step.
  const bool has_changed = step != steps_.present && step > 0;
  if (has_changed) steps_.present = step;
  for (Partner& partner : partners_) {
    if (has_changed) partner.laws.set_steps(steps_);
    partner.offsets.visit_state(visit);
  }
}

void ContactSolver::find(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                         const ElementBatch& batch, const std::vector<DynamicBody>& bodies, double cord_speed,
                         double dt, ContactedCoordinates& contacted) {
  contacts_.clear();
  places_.clear();
  deepest_penetration_ = 0;
  deepest_part_ = {};
  if (steps_.reference == 0) set_reference_step(dt);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    find_contacts(static_cast<std::int32_t>(b), coordinates, velocities, batch, bodies[b], cord_speed, dt);
  }
  find_runs(batch, contacts_.from(0));
  share_inertia(contacts_.from(0), contacted);
}

// Force of a spring by what the softest one bears.
double ContactSolver::load_of(const ContactBlock& block, int lane, double body_mass) {
  const double compression = std::max(block.penetration[lane], 0.0);
  const ContactLaw& law = partners_[static_cast<std::size_t>(block.body)].laws.of(block.element[lane], block.part[lane],
                                                                                  block.is_cord_end[lane], body_mass);
  return block.stiffness[lane] * compression * std::sqrt(compression) / law.largest;
}

ContactSolver::Outcome ContactSolver::outcome_of(const Partner& partner, double body_mass) {
  Outcome outcome;
  for (const std::int32_t place : places_of(partner)) {
    const ContactBlock& block = contacts_[static_cast<std::size_t>(place / kBlockSize)];
    const int lane = place % kBlockSize;
    outcome.stops += block.is_stopped[lane] > 0 ? 1 : 0;
    outcome.unresolved += block.squared_phase[lane] > 1 ? 1 : 0;
    double squared_phase = block.squared_phase[lane];
    if (kFinerPhase * squared_phase > outcome.squared_phase && load_of(block, lane, body_mass) > kMuchLoad) {
      squared_phase *= kFinerPhase;
    }
    outcome.squared_phase = std::max(outcome.squared_phase, squared_phase);
    outcome.power += contact_kernel::ContactPower{block.damping_power[lane], block.friction_power[lane]};
  }
  return outcome;
}

void ContactSolver::add_forces(const CoordinateVectors& velocities, ContactedCoordinates& contacted,
                               std::span<const double> inverse_mass, const std::vector<DynamicBody>& bodies,
                               const StepTimes& times, AppliedForces& applied, std::vector<Wrench>& wrenches) {
  const contact_kernel::ForceView view{.velocities = velocities.rows().first,
                                       .predicted = contacted.predicted_rows(),
                                       .shared_weight = contacted.shared_weights(),
                                       .inverse_mass = inverse_mass.data(),
                                       .friction = settings_.friction,
                                       .friction_velocity = settings_.friction_velocity,
                                       .dt = times.drift,
                                       .inertia_factor = times.inertia_factor()};
  stops_ = unresolved_ = 0;
  largest_squared_phase_ = 0;
  power_before_ = {};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    body_force_[b].setZero();
    const Partner& partner = partners_[b];
    if (partner.first == partner.last) continue;
    const std::span<ContactBlock> contacts = contacts_.range(partner.first, partner.last);
    force_kernels().forces(view, motion_of(bodies[b], sectors_ * partner.shares), contacts.data(), contacts.size());
    const Outcome outcome = outcome_of(partner, bodies[b].least_mass());
    unresolved_ += outcome.unresolved;
    largest_squared_phase_ = std::max(largest_squared_phase_, outcome.squared_phase);
    if (outcome.stops > 0) {
      stops_ += outcome.stops;
      complete_stops(contacts_.from(0), places_of(partner), bodies[b].rigid(), partner.shares, contacted, inverse_mass,
                     times);
    }
    power_before_ += outcome.stops > 0 ? power_of(b, velocities.rows(), bodies[b]) : outcome.power;
    add_to_coordinates(contacts, applied);
    const Wrench on_body = of_all_sectors(force_on_body(contacts, bodies[b].rigid().position()), sectors_);
    body_force_[b] = on_body.force;
    wrenches[b] += on_body;
  }
}

double ContactSolver::stored_energy() const {
  double energy = 0;
  for_each_contact([&](const ContactBlock& block, int lane) {
    energy += block.share[lane] * elastic_energy({block.stiffness[lane], 0}, block.penetration[lane]);
  });
  return energy;
}

// A place is sum S_i q_i, where S_2 and S_4 are proportional to the length L. It moves by (dL/dt)/L (S_2 g_1 + S_4
// g_2).
double ContactSolver::fed_power(const CoordinateVectors& coordinates, const ElementBatch& batch) const {
  double power = 0;
  if (std::ranges::none_of(contacts_.range(0, contacts_.size()), &ContactBlock::feeds)) return power;
  for_each_contact([&](const ContactBlock& block, int lane) {
    if (!block.feeds) return;
    const std::int32_t element = block.element[lane];
    const double rate = batch.block(element / kBlockSize).length_rate[element % kBlockSize];
    if (rate == 0) return;
    const Vector3d along = block.weight[1][lane] * coordinates.get(block.coordinate[1][lane]) +
                           block.weight[3][lane] * coordinates.get(block.coordinate[3][lane]);
    power -= rate * block.elastic[lane] * symmetric_dot(along, lane_of(block.normal, lane));
  });
  return power;
}

contact_kernel::ContactPower ContactSolver::power_of(std::size_t body, const CoordinateRows& velocities,
                                                     const DynamicBody& dynamic) const {
  const Partner& partner = partners_[body];
  powers_.resize(contacts_.size());
  const std::span<const ContactBlock> contacts = contacts_.range(partner.first, partner.last);
  force_kernels().power(velocities, motion_of(dynamic, sectors_ * partner.shares), contacts.data(), contacts.size(),
                        powers_.data() + partner.first);
  contact_kernel::ContactPower sums[kBlockSize];  // side by side, which is faster than one after the other
  std::size_t next = 0;
  for (const std::int32_t place : places_of(partner)) {
    const contact_kernel::LanePowers& powers = powers_[static_cast<std::size_t>(place / kBlockSize)];
    contact_kernel::ContactPower& sum = sums[next++ % kBlockSize];
    sum.damping -= powers.damping[place % kBlockSize];
    sum.friction -= powers.friction[place % kBlockSize];
  }
  contact_kernel::ContactPower total;
  for (const contact_kernel::ContactPower& sum : sums) total += sum;
  return total;
}

contact_kernel::ContactPower ContactSolver::dissipated_power(const CoordinateVectors& velocities,
                                                             const std::vector<DynamicBody>& bodies) const {
  contact_kernel::ContactPower total;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (partners_[b].first < partners_[b].last) total += power_of(b, velocities.rows(), bodies[b]);
  }
  return total;
}

}  // namespace netpocket
