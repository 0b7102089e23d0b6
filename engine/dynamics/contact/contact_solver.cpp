#include "engine/dynamics/contact/contact_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/contact/contact_blocks.h"
#include "engine/dynamics/contact/contact_stop.h"
#include "engine/dynamics/contact/cord_chain.h"
#include "engine/math/instruction_set.h"
#include "engine/math/symmetric_algebra.h"

namespace netpocket {
namespace {

using Eigen::Vector3d;

// Impact speed (m/s) that determines a contact's greatest depth. A faster impact is stopped there within one step.
constexpr double kSoftImpact = 10;
// Largest penetration of a cord's axis as a fraction of a solid's thickness, well before the opposite side becomes the
// nearer one.
constexpr double kThicknessPart = 0.25;
// A search ahead is needed only if kGrowingWay times the distance of a step exceeds this many radii of the thinnest
// cord. Otherwise a cord is found before it is deeper than its radius.
constexpr double kShortWay = 2;
// Factor on the distance of a step at the present speed, as an allowance for acceleration.
constexpr double kGrowingWay = 2;
// Springs become softer again when a step exceeds the one they are for by this factor. They resolve longer ones too.
constexpr double kLongStep = 0.7;
// Springs become stiffer when a step is below this part of the one they are for.
constexpr double kShortStep = 0.25;

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
      damping_(restitution_damping(model.contact.restitution)),
      body_force_(model.bodies.size(), Vector3d::Zero()) {
  const std::vector<std::int32_t> next = next_elements(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    ContactSearch search(model, next, static_cast<std::int32_t>(b));
    std::vector<std::vector<Law>> laws(search.parts().size());
    SpringOffsets offsets(search.parts().size(), search.holder_count());
    partners_.push_back({.search = std::move(search), .laws = std::move(laws), .offsets = std::move(offsets)});
  }
}

void ContactSolver::forget_candidates() {
  for (Partner& partner : partners_) partner.search.forget();
}

void ContactSolver::set_reference_step(double dt) {
  reference_step_ = stiffness_step_ = dt;
  for (Partner& partner : partners_) {
    partner.laws.assign(partner.search.parts().size(), {});
    partner.offsets.clear();
  }
}

void ContactSolver::note_motion(double cords, std::span<const double> bodies) {
  for (std::size_t b = 0; b < partners_.size(); ++b) {
    partners_[b].search.note_way(cords + bodies[b]);
  }
}

// The cord's mass at a place is that of half an element, or of a quarter at the end of a cord.
ContactSolver::Law ContactSolver::make_law(const CordTouch& touch, std::int32_t body, double body_mass) const {
  const CableMaterial& material = model_.material_of(touch.element);
  const ModelBody& partner = model_.bodies[static_cast<std::size_t>(body)];
  const double modulus = effective_modulus({material.youngs_modulus, material.poisson_ratio},
                                           {partner.youngs_modulus, partner.poisson_ratio});
  const double of_materials =
      hertz_stiffness(modulus, effective_radius(material.radius, contact_radius(partner.shape)));
  const double part = (touch.is_cord_end ? 0.5 : 1.0) / ContactSearch::kHalves;
  const double length = part * model_.elements[static_cast<std::size_t>(touch.element)].length;
  const double mass = effective_mass(material.section.mass_per_length * length, body_mass);
  const double stiffness = std::min(of_materials, resolved_stiffness(mass, stiffness_step_));
  const double softest = std::min(of_materials, resolved_stiffness(mass, reference_step_));
  const ContactPart& solid =
      partners_[static_cast<std::size_t>(body)].search.parts()[static_cast<std::size_t>(touch.part)];
  return {{stiffness, damping_ * std::sqrt(stiffness * mass)},
          depth_of_impact(mass, softest, kSoftImpact),
          material.radius + kThicknessPart * solid.thickness,
          stiffness / of_materials};
}

const ContactSolver::Law& ContactSolver::law_of(const CordTouch& touch, std::int32_t body, double body_mass) {
  std::vector<Law>& laws = partners_[static_cast<std::size_t>(body)].laws[static_cast<std::size_t>(touch.part)];
  if (laws.empty()) laws.resize(2 * model_.elements.size());
  Law& law = laws[2 * static_cast<std::size_t>(touch.element) + (touch.is_cord_end ? 1 : 0)];
  if (law.law.stiffness == 0) law = make_law(touch, body, body_mass);
  return law;
}

// Shape functions at the place of a touch on an element of `length` (m).
ElementWeights ContactSolver::weights_at(const CordTouch& touch, double length) const {
  const ElementWeights start = polyline_.weights(touch.segment, length);
  const ElementWeights end = polyline_.weights(touch.segment + 1, length);
  ElementWeights weights{};
  for (std::size_t i = 0; i < 4; ++i) weights[i] = (1 - touch.t) * start[i] + touch.t * end[i];
  return weights;
}

void ContactSolver::note_depth(std::int32_t body, double body_mass, const CordTouch& touch) {
  deepest_penetration_ = std::max(deepest_penetration_, touch.penetration);
  const double radius = partners_[static_cast<std::size_t>(body)].search.radius_of(touch.element);
  constexpr double kRounding = 1 - 1e-12;
  if (touch.penetration <= kRounding * deepest_part_.part * radius) return;  // saves most divisions
  const double part = touch.penetration / radius;
  if (part <= deepest_part_.part) return;
  deepest_part_ = {part, touch.element, body, law_of(touch, body, body_mass).softening};
}

void ContactSolver::add_contact(std::int32_t body, double body_mass, const CordTouch& touch, double length) {
  Partner& partner = partners_[static_cast<std::size_t>(body)];
  const auto is_for_touch = [&](const ContactBlock& open) {
    return open.first_part == touch.part && open.first_place == touch.first_place;
  };
  ContactBlock& block =
      *std::find_if(contacts_.begin() + static_cast<std::ptrdiff_t>(first_open_), contacts_.end(), is_for_touch);
  const int lane = touch.first_element % kBlockSize;
  block.used |= 1U << lane;
  places_.push_back(static_cast<std::int32_t>(&block - contacts_.data()) * kBlockSize + lane);
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
  const Law& law = law_of(touch, body, body_mass);
  const double offset = partner.offsets.follow(touch);
  block.penetration[lane] = touch.penetration - offset;
  block.offset[lane] = offset;
  block.stiffness[lane] = law.law.stiffness;
  block.damping[lane] = law.law.damping;
  block.deepest[lane] = std::min(law.impact, law.deepest - offset);
  block.share[lane] = touch.share;
  block.element[lane] = touch.element;
  block.part[lane] = touch.part;
  block.holder[lane] = touch.holder;
  block.is_cord_end[lane] = touch.is_cord_end;
  partner.shares += touch.share;
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
  const auto length_of = [&](const CordTouch& touch) {
    return batch.block(touch.element / kBlockSize).length[touch.element % kBlockSize];
  };
  std::erase_if(touches_, [&](const CordTouch& touch) {
    return !(touch.penetration > 0) && !hits_within_step(touch, body, length_of(touch), velocities, dynamic, dt);
  });
  const auto elements_of = [](const CordTouch& touch) { return touch.first_element / kBlockSize; };
  for (auto first = touches_.begin(); first != touches_.end();) {
    const auto last =
        std::find_if(first, touches_.end(), [&](const CordTouch& t) { return elements_of(t) != elements_of(*first); });
    first_open_ = open_blocks({first, last}, body, contacts_);
    for (; first != last; ++first) {
      if (first->penetration > 0) note_depth(body, dynamic.least_mass(), *first);
      add_contact(body, dynamic.least_mass(), *first, length_of(*first));
    }
  }
  partner.last = contacts_.size();
  partner.last_place = places_.size();
  partner.offsets.keep_only(touches_);
}

template <typename Function>
void ContactSolver::for_each_contact(const Function& function) const {
  for (const std::int32_t place : places_) {
    function(contacts_[static_cast<std::size_t>(place / kBlockSize)], place % kBlockSize);
  }
}

double ContactSolver::stiffness_step_for(double dt) const {
  constexpr int kMostHalvings = 7;  // stiffer springs are those of the materials
  const double shortest = std::ldexp(reference_step_, -kMostHalvings);
  double step = stiffness_step_;
  while (dt <= kShortStep * step && step > shortest) step *= 0.5;
  while (dt > kLongStep * step && step < reference_step_) step *= 2;
  return step;
}

// A spring stores 2/5 K s^2.5 at the compression s. With another stiffness K it stores the same at a compression in
// proportion to K^-0.4. A spring cannot begin outside the surface.
void ContactSolver::fit_stiffness(double dt, const std::vector<DynamicBody>& bodies) {
  stiffness_step_ = stiffness_step_for(dt);
  for (Partner& partner : partners_) partner.laws.assign(partner.search.parts().size(), {});
  for_each_contact([&](const ContactBlock& block, int lane) {
    const double compression = block.penetration[lane], depth = compression + block.offset[lane];
    if (!(compression > 0)) return;
    const auto body = static_cast<std::size_t>(block.body);
    CordTouch touch{};
    touch.element = block.element[lane];
    touch.part = block.part[lane];
    touch.is_cord_end = block.is_cord_end[lane];
    const double stiffness = law_of(touch, block.body, bodies[body].least_mass()).law.stiffness;
    const double root = fifth_root(block.stiffness[lane] / stiffness);
    partners_[body].offsets.set(touch.part, block.holder[lane], std::max(depth - root * root * compression, 0.0));
  });
}

void ContactSolver::visit_state(const std::function<void(double&)>& visit) {
  double step = stiffness_step_;
  visit(step);
  for (Partner& partner : partners_) {
    // A file may hold a number that is not a step.
    if (step != stiffness_step_ && step > 0) partner.laws.assign(partner.search.parts().size(), {});
    partner.offsets.visit_state(visit);
  }
  if (step > 0) stiffness_step_ = step;
}

void ContactSolver::find(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                         const ElementBatch& batch, const std::vector<DynamicBody>& bodies, double cord_speed,
                         double dt, ContactedCoordinates& contacted) {
  contacts_.clear();
  places_.clear();
  deepest_penetration_ = 0;
  deepest_part_ = {};
  if (reference_step_ == 0) set_reference_step(dt);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    find_contacts(static_cast<std::int32_t>(b), coordinates, velocities, batch, bodies[b], cord_speed, dt);
  }
  find_runs(batch, contacts_);
  share_inertia(contacts_, contacted);
}

ContactSolver::Outcome ContactSolver::outcome_of(const Partner& partner) const {
  Outcome outcome;
  for (const std::int32_t place : places_of(partner)) {
    const ContactBlock& block = contacts_[static_cast<std::size_t>(place / kBlockSize)];
    const int lane = place % kBlockSize;
    outcome.stops += block.is_stopped[lane] > 0 ? 1 : 0;
    outcome.unresolved += block.is_unresolved[lane] > 0 ? 1 : 0;
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
  power_before_ = {};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    body_force_[b].setZero();
    const Partner& partner = partners_[b];
    if (partner.first == partner.last) continue;
    const std::span<ContactBlock> contacts(contacts_.data() + partner.first, partner.last - partner.first);
    force_kernels().forces(view, motion_of(bodies[b], partner.shares), contacts.data(), contacts.size());
    const Outcome outcome = outcome_of(partner);
    unresolved_ += outcome.unresolved;
    if (outcome.stops > 0) {
      stops_ += outcome.stops;
      complete_stops(contacts_, places_of(partner), bodies[b].rigid(), partner.shares, contacted, inverse_mass, times);
    }
    power_before_ += outcome.stops > 0 ? power_of(b, velocities.rows(), bodies[b]) : outcome.power;
    add_to_coordinates(contacts, applied);
    const Wrench on_body = force_on_body(contacts, bodies[b].rigid().position());
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
  if (std::ranges::none_of(contacts_, &ContactBlock::feeds)) return power;
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
  force_kernels().power(velocities, motion_of(dynamic, partner.shares), contacts_.data() + partner.first,
                        partner.last - partner.first, powers_.data() + partner.first);
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

std::optional<ContactSolver::Depth> ContactSolver::deepest_contact() const {
  std::optional<Depth> deepest;
  for_each_contact([&](const ContactBlock& block, int lane) {
    if (deepest && deepest->penetration >= block.penetration[lane] + block.offset[lane]) return;
    deepest = Depth{block.element[lane], block.body, block.penetration[lane] + block.offset[lane]};
  });
  return deepest;
}

std::vector<ContactPoint> ContactSolver::contacts() const {
  std::vector<ContactPoint> result;
  for_each_contact([&](const ContactBlock& block, int lane) {
    const Vector3d force = lane_of(block.force, lane);
    if (force.squaredNorm() == 0) return;
    const double to_surface = model_.radius_of(block.element[lane]) - (block.penetration[lane] + block.offset[lane]);
    const Vector3d surface = lane_of(block.point, lane) - to_surface * lane_of(block.normal, lane);
    result.push_back({surface, -force, block.element[lane], block.body});
  });
  return result;
}

}  // namespace netpocket
