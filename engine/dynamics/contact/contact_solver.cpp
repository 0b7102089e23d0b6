#include "engine/dynamics/contact/contact_solver.h"

#include <algorithm>
#include <cmath>

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

int count_marked(std::span<const ContactBlock> contacts, const double (ContactBlock::*mark)[kBlockSize]) {
  int count = 0;
  for (const ContactBlock& block : contacts) {
    const double* marks = block.*mark;
    count += static_cast<int>(std::count_if(marks, marks + block.count, [](double m) { return m > 0; }));
  }
  return count;
}

// Power as found by the force kernel. Valid only if no contact was stopped.
contact_kernel::ContactPower stored_power(std::span<const ContactBlock> contacts) {
  contact_kernel::ContactPower power;
  for (const ContactBlock& block : contacts) {
    for (int lane = 0; lane < block.count; ++lane) {
      power += contact_kernel::ContactPower{block.damping_power[lane], block.friction_power[lane]};
    }
  }
  return power;
}

// Unused lanes read the data of the first contact and exert no force.
void fill_idle_lanes(ContactBlock& block) {
  for (int lane = block.count; lane < kBlockSize; ++lane) {
    for (int corner = 0; corner < 4; ++corner) {
      block.weight[corner][lane] = 0;
      block.coordinate[corner][lane] = block.coordinate[corner][0];
      block.place[corner][lane] = block.place[corner][0];
    }
    for (int axis = 0; axis < 3; ++axis) {
      block.point[axis][lane] = block.point[axis][0];
      block.normal[axis][lane] = 0;
    }
    block.penetration[lane] = block.stiffness[lane] = block.damping[lane] = block.deepest[lane] = 0;
    block.share[lane] = 0;
  }
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
  const double part = touch.penetration / model_.radius_of(touch.element);
  if (part <= deepest_part_.part) return;
  deepest_part_ = {part, touch.element, body, law_of(touch, body, body_mass).softening};
}

void ContactSolver::add_contact(std::int32_t body, double body_mass, const CordTouch& touch, double length) {
  Partner& partner = partners_[static_cast<std::size_t>(body)];
  if (partner.first == contacts_.size() || contacts_.back().count == kBlockSize) {
    contacts_.emplace_back();
    contacts_.back().body = body;
  }
  ContactBlock& block = contacts_.back();
  const int lane = block.count++;
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
  partner.shares = 0;
  if (!is_sound(Eigen::AlignedBox3d(dynamic.centre()))) return;
  partner.search.find(coordinates, batch, dynamic, way_ahead(body, dynamic, cord_speed, dt), touches_);
  for (const CordTouch& touch : touches_) {
    const double length = batch.block(touch.element / kBlockSize).length[touch.element % kBlockSize];
    if (touch.penetration > 0) {
      note_depth(body, dynamic.least_mass(), touch);
    } else if (!hits_within_step(touch, body, length, velocities, dynamic, dt)) {
      continue;
    }
    add_contact(body, dynamic.least_mass(), touch, length);
  }
  partner.last = contacts_.size();
  partner.offsets.keep_only(touches_);
}

template <typename Function>
void ContactSolver::for_each_contact(const Function& function) const {
  for (const ContactBlock& block : contacts_) {
    for (int lane = 0; lane < block.count; ++lane) function(block, lane);
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

template <typename Function>
void ContactSolver::for_each_corner(std::span<ContactBlock> contacts, const Function& function) {
  for (int corner = 0; corner < 4; ++corner) {
    for (ContactBlock& block : contacts) {
      for (int lane = 0; lane < block.count; ++lane) function(block, lane, corner);
    }
  }
}

void ContactSolver::share_inertia(ContactedCoordinates& contacted) {
  for_each_corner(contacts_, [&](ContactBlock& block, int lane, int corner) {
    block.place[corner][lane] =
        contacted.share(block.coordinate[corner][lane], block.share[lane] * block.weight[corner][lane]);
  });
  for (ContactBlock& block : contacts_) fill_idle_lanes(block);
}

void ContactSolver::find(const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                         const ElementBatch& batch, const std::vector<DynamicBody>& bodies, double cord_speed,
                         double dt, ContactedCoordinates& contacted) {
  contacts_.clear();
  deepest_penetration_ = 0;
  deepest_part_ = {};
  if (reference_step_ == 0) set_reference_step(dt);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    find_contacts(static_cast<std::int32_t>(b), coordinates, velocities, batch, bodies[b], cord_speed, dt);
  }
  share_inertia(contacted);
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
    unresolved_ += count_marked(contacts, &ContactBlock::is_unresolved);
    const int stopped = count_marked(contacts, &ContactBlock::is_stopped);
    if (stopped > 0) {
      stops_ += stopped;
      complete_stops(contacts, bodies[b].rigid(), partner.shares, contacted, inverse_mass, times);
    }
    power_before_ += stopped > 0 ? power_of(b, velocities.rows(), bodies[b]) : stored_power(contacts);
    for_each_corner(contacts, [&](const ContactBlock& block, int lane, int corner) {
      applied.add(block.coordinate[corner][lane], block.weight[corner][lane] * lane_of(block.force, lane));
    });
    const SectorSum<Vector3d> nothing(Vector3d::Zero());
    BodySums sums{nothing, nothing};
    for (const ContactBlock& block : contacts) {
      for (int lane = 0; lane < block.count; ++lane) {
        const Vector3d force = lane_of(block.force, lane);
        sums.force.add(block.element[lane], -force);
        const Vector3d arm = lane_of(block.point, lane) - bodies[b].rigid().position();
        sums.torque.add(block.element[lane], arm.cross(-force));
      }
    }
    body_force_[b] = sums.force.total();
    wrenches[b] += Wrench{body_force_[b], sums.torque.total()};
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
  for_each_contact([&](const ContactBlock& block, int lane) {
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
  return force_kernels().power(velocities, motion_of(dynamic, partner.shares), contacts_.data() + partner.first,
                               partner.last - partner.first);
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
