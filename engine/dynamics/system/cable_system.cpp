#include "engine/dynamics/system/cable_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/element_states.h"
#include "engine/dynamics/system/energy_account.h"
#include "engine/dynamics/system/leapfrog.h"
#include "engine/dynamics/system/system_contacts.h"
#include "engine/dynamics/system/system_forces.h"
#include "engine/dynamics/system/system_threads.h"
#include "engine/dynamics/system/travelled_way.h"

namespace netpocket {
namespace {

// A speed above this (m/s) is a failure of the integration, not a motion.
constexpr double kRunawaySpeed = 1e5;
// Number of coordinates that a thread examines at once.
constexpr int kSoundRange = 8192;
// Step (s) for forces that are needed before the first step.
constexpr double kStepBeforeFirst = 1e-4;

// For messages. Of a runaway only the order of magnitude matters.
std::string speed_text(double speed) {
  return speed < kRunawaySpeed ? fmt::format("{:.3g} m/s", speed) : fmt::format("{:.3g} km/s", speed / 1000);
}

// `first` must be the first coordinate of its block.
void copy_coordinates(const CoordinateVectors& vectors, std::int32_t first, std::int32_t count,
                      Eigen::Matrix3Xd& columns) {
  using Block = Eigen::Map<const Eigen::Matrix<double, kBlockSize, kVectorRows>, Eigen::Aligned64>;
  columns.resize(kVectorRows, count);
  const double* rows = vectors.rows().first + static_cast<std::ptrdiff_t>(first) * kVectorRows;
  for (std::int32_t i = 0; i < count; i += kBlockSize, rows += kVectorRows * kBlockSize) {
    const std::int32_t here = std::min(kBlockSize, count - i);
    if (here == kBlockSize) {
      columns.middleCols<kBlockSize>(i) = Block(rows).transpose();
    } else {
      columns.middleCols(i, here) = Block(rows).topRows(here).transpose();
    }
  }
}

}  // namespace

// The parts of a system. Each refers to those before it.
struct CableSystem::Impl {
  Impl(Model&& source, const SystemOptions& options)
      : model(std::move(source)),
        threads(model.elements.size(), options.threads),
        elements(model, options.evaluation),
        state(model, elements.mass()),
        element_states(model, elements, state, threads),
        travelled(model, elements, state, threads),
        ring_ropes(model, state.layout),
        contacts(model, elements, state, threads),
        forces(model, elements, state, ring_ropes, contacts, travelled, threads),
        integrator(model, elements, state, forces, threads, travelled.weights()),
        energies(elements, state, ring_ropes, contacts, forces, element_states, integrator) {
    ring_ropes.stretch(state.coordinates);
    begin_account();
  }

  void begin_account();
  void fix_contacts(double dt);
  void fit_contacts(double dt);
  void step(double dt);
  void step_locked(LockedBodies& lock, double kick, double dt);
  void step_bodies(double kick, double dt);
  void keep_forces_current() { forces.keep_current(state.last_step > 0 ? state.last_step : kStepBeforeFirst); }
  void state_has_jumped();
  void visit_state(const std::function<void(double&)>& visit);
  bool looks_sound() const;
  // Index into Model::ring_ropes of what a run numbers as `rope`; nothing if it is one of Model::ropes.
  std::optional<std::size_t> ring_rope(std::int32_t rope) const {
    const auto index = static_cast<std::size_t>(rope);
    return index < model.ropes.size() ? std::nullopt : std::optional(index - model.ropes.size());
  }
  std::string contact_of(std::int32_t element) const;

  Model model;
  SystemThreads threads;
  CableElements elements;
  CableState state;
  ElementStates element_states;
  TravelledWay travelled;
  RingRopes ring_ropes;
  SystemContacts contacts;
  SystemForces forces;
  Leapfrog integrator;
  EnergyAccount energies;
  SafeguardCounts safeguards;
};

// Called again when a system is displaced or its springs change before the first step: the account then begins at that
// state.
void CableSystem::Impl::begin_account() {
  forces.compute(kStepBeforeFirst);
  energies.begin();
}

// The stiffness of contacts is based on the first step. Energy that their springs store at the start belongs to the
// initial energy.
void CableSystem::Impl::fix_contacts(double dt) {
  if (contacts.reference_step() != 0) return;
  contacts.set_reference_step(dt);
  begin_account();
  forces.forget();
}

// Energy that springs of contacts lose as they become softer is spent.
void CableSystem::Impl::fit_contacts(double dt) {
  if (contacts.fits(dt)) return;
  forces.keep_current(dt);
  const double before = contacts.energy_with_bodies();
  contacts.fit_stiffness(dt);
  forces.compute(dt);
  energies.add_spent_in_contacts(std::max(before - contacts.energy_with_bodies(), 0.0));
}

void CableSystem::Impl::step(double dt) {
  fix_contacts(dt);
  fit_contacts(dt);
  forces.keep_for_step(dt);
  const double kick = integrator.kick(dt);
  energies.before_step(kick);
  safeguards += forces.hinge_safeguards();
  energies.add_spent_in_contacts(contacts.note_step(kick, safeguards));
  const auto fastest = integrator.move(state.velocities, state.coordinates, kick, dt);
  energies.after_coordinates(kick);
  elements.ropes().finish_step(dt);
  step_bodies(kick, dt);
  energies.after_bodies(kick);
  if (!ring_ropes.empty()) energies.add(ring_ropes.advance(state.coordinates, dt));
  state.advance_time(dt);
  travelled.note_step(dt, fastest);
}

void CableSystem::Impl::step_locked(LockedBodies& lock, double kick, double dt) {
  const std::size_t members[] = {static_cast<std::size_t>(lock.carrier()), static_cast<std::size_t>(lock.carried())};
  const TravelledWay::Pose before[] = {TravelledWay::pose_of(state.bodies[members[0]]),
                                       TravelledWay::pose_of(state.bodies[members[1]])};
  energies.add_input(lock.step(state.bodies, forces.wrenches(), state.controls[members[0]], kick, dt));
  for (const int i : {0, 1}) travelled.note_body(members[i], before[i]);
}

void CableSystem::Impl::step_bodies(double kick, double dt) {
  for (LockedBodies& lock : state.locks) {
    if (lock.is_locked()) step_locked(lock, kick, dt);
  }
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    if (state.lock_of(b) != nullptr) continue;
    const TravelledWay::Pose before = TravelledWay::pose_of(state.bodies[b]);
    energies.add_input(state.bodies[b].step(forces.wrenches()[b], state.controls[b], kick, dt));
    travelled.note_body(b, before);
  }
  for (DynamicBody& body : state.bodies) body.move_attachments(state.coordinates, state.velocities);
}

// To be called when positions have changed in another way than by a step.
void CableSystem::Impl::state_has_jumped() {
  ++state.version;
  contacts.forget_candidates();
}

// Whether every number is finite and no element end can exceed kRunawaySpeed. A cheap test that errs on the safe side.
bool CableSystem::Impl::looks_sound() const {
  double longest = 1;
  for (const double length : elements.lengths()) longest = std::max(longest, length);
  const double limit = kRunawaySpeed * kRunawaySpeed / (longest * longest);
  const auto are_sound = [&](int first, int last) -> char {
    return std::isfinite(largest_square(state.coordinates.squared_norms(first, last - first))) &&
                   largest_square(state.velocities.squared_norms(first, last - first)) < limit
               ? 1
               : 0;
  };
  const auto sound = values_of_ranges<char>(threads.loop(), state.layout.size(), kSoundRange, are_sound);
  return std::ranges::all_of(sound, [](char part) { return part != 0; });
}

// The body that an element touched in the last step, for messages.
std::string CableSystem::Impl::contact_of(std::int32_t element) const {
  for (const ContactPoint& contact : contacts.with_bodies().contacts()) {
    if (contact.element == element) return fmt::format(", in contact with the {},", model.bodies[contact.body].name);
  }
  return ", without contact,";
}

void CableSystem::Impl::visit_state(const std::function<void(double&)>& visit) {
  // Bits are compared because 0.0 and -0.0 compare equal.
  bool changed = false;
  const std::function<void(double&)> visit_number = [&](double& number) {
    const auto before = std::bit_cast<std::uint64_t>(number);
    visit(number);
    changed = changed || std::bit_cast<std::uint64_t>(number) != before;
  };
  state.visit_motion(visit_number);
  contacts.visit_impulses(visit_number);
  double friction = contacts.friction();
  visit_number(friction);
  if (friction != contacts.friction()) contacts.set_friction(friction);
  forces.wrinkling().visit_state(visit_number);
  state.visit_time(visit_number);
  energies.visit_state(visit_number);
  visit_number(contacts.depths().penetration);
  double reference_step = contacts.reference_step();
  visit_number(reference_step);
  if (reference_step != contacts.reference_step()) contacts.set_reference_step(reference_step);
  contacts.visit_springs(visit_number);
  contacts.depths().pressed.visit_state(visit);
  contacts.depths().overlapping.visit_state(visit);
  safeguards.visit_state(visit);
  contacts.visit_bodies(visit_number);
  elements.ropes().visit_state(visit_number);
  ring_ropes.visit_state(visit_number);
  if (changed) state_has_jumped();
}

CableSystem::CableSystem(Model model, const SystemOptions& options) {
  if (const auto fault = model.find_fault()) throw std::invalid_argument(*fault);
  impl_ = std::make_unique<Impl>(std::move(model), options);
}
CableSystem::~CableSystem() = default;
CableSystem::CableSystem(CableSystem&&) noexcept = default;
CableSystem& CableSystem::operator=(CableSystem&&) noexcept = default;

const Model& CableSystem::model() const { return impl_->model; }
double CableSystem::time() const { return impl_->state.time; }
std::int64_t CableSystem::steps() const { return impl_->state.steps; }
double CableSystem::helpers_cpu_seconds() const { return impl_->threads.helpers_cpu_seconds(); }
ElementEvaluation CableSystem::evaluation() const {
  return impl_->elements.is_full() ? ElementEvaluation::full : ElementEvaluation::mean_strain;
}
void CableSystem::step(double dt) { impl_->step(dt); }

StableStep CableSystem::stable_step() {
  Impl& s = *impl_;
  s.elements.update_ropes();  // until now they have the length of the last step's start
  const std::vector<BatchElement> now = s.elements.batch_elements();
  if (s.elements.is_full()) {
    return with_lines(s.model, s.state.layout, s.elements.inverse_mass(),
                      find_stable_step_of_full_elements(s.model, now, s.state.coordinates));
  }
  return find_stable_step(s.model, s.state.layout, now, s.elements.inverse_mass(), s.state.coordinates);
}

double CableSystem::stable_step_as_bent(const StableStep& straight) {
  if (straight.stiffness == 0) return straight.step;
  impl_->elements.update_ropes();
  return impl_->element_states.stable_step(straight);
}

std::optional<std::string> CableSystem::fault() const {
  const Impl& s = *impl_;
  const std::size_t suspects = s.looks_sound() ? 0 : s.model.elements.size();
  for (std::size_t i = 0; i < suspects; ++i) {
    for (int corner = 0; corner < 4; ++corner) {
      const std::int32_t coordinate = s.elements.coordinate(i, corner);
      const double lever = corner % 2 == 0 ? 1.0 : s.elements.lengths()[i];
      const double speed = s.state.velocities.get(coordinate).norm() * lever;
      if (speed < kRunawaySpeed && s.state.coordinates.get(coordinate).allFinite()) continue;
      return fmt::format("{} (element {}){} moves at {}", s.model.threads[s.model.elements[i].thread], i,
                         s.contact_of(static_cast<std::int32_t>(i)), speed_text(speed));
    }
  }
  for (std::size_t b = 0; b < s.state.bodies.size(); ++b) {
    const RigidBody& body = s.state.bodies[b].rigid();
    if (body.position().allFinite() && body.velocity().norm() < kRunawaySpeed && body.angular_momentum().allFinite())
      continue;
    return fmt::format("the {} moves at {}", s.model.bodies[b].name, speed_text(body.velocity().norm()));
  }
  return std::nullopt;
}

Eigen::Vector3d CableSystem::position(std::int32_t node) const {
  return impl_->state.coordinates.get(impl_->state.layout.position(node));
}
Eigen::Vector3d CableSystem::velocity(std::int32_t node) const {
  return impl_->state.velocities.get(impl_->state.layout.position(node));
}
Eigen::Vector3d CableSystem::gradient(std::int32_t gradient) const {
  return impl_->state.coordinates.get(impl_->state.layout.gradient(gradient));
}
BodyState CableSystem::body(std::int32_t body) const { return impl_->state.bodies[body].state(); }
RigidMotion CableSystem::motion(std::int32_t body) const { return impl_->state.bodies[body].motion(); }
const Wrench& CableSystem::exerted(std::int32_t body) const { return impl_->state.bodies[body].exerted(); }
const RopeMotion& CableSystem::rope_motion(std::int32_t rope) const {
  const auto ring_rope = impl_->ring_rope(rope);
  return ring_rope ? impl_->ring_ropes.motion(*ring_rope) : impl_->elements.ropes().motion(rope);
}
double CableSystem::rope_tension(std::int32_t rope) const {
  const auto ring_rope = impl_->ring_rope(rope);
  return ring_rope ? impl_->ring_ropes.tension(*ring_rope) : impl_->element_states.rope_tension(rope);
}
std::vector<double> CableSystem::ring_rope_lengths(std::int32_t ring_rope) const {
  return impl_->ring_ropes.lengths(static_cast<std::size_t>(ring_rope));
}
std::vector<double> CableSystem::ring_rope_tensions(std::int32_t ring_rope) const {
  return impl_->ring_ropes.tensions(static_cast<std::size_t>(ring_rope));
}

void CableSystem::displace(std::span<const Eigen::Vector3d> displacements) {
  Impl& s = *impl_;
  for (std::size_t i = 0; i < displacements.size(); ++i) {
    if (s.model.nodes[i].support != Support::free) continue;
    s.state.coordinates.add(s.state.layout.position(static_cast<std::int32_t>(i)), displacements[i]);
  }
  s.ring_ropes.stretch(s.state.coordinates);
  s.state_has_jumped();
  s.begin_account();
}
void CableSystem::control(std::int32_t body, const BodyControl& control) {
  impl_->state.controls[body] = control;
  impl_->energies.forget_audit();
  if (impl_->contacts.depend_on_controls()) impl_->forces.forget();
}
void CableSystem::wind(std::int32_t rope, const RopeMotion& motion) {
  if (const auto ring_rope = impl_->ring_rope(rope)) {
    impl_->ring_ropes.wind(*ring_rope, motion);
  } else {
    impl_->elements.ropes().wind(rope, motion);
  }
}
void CableSystem::set_wrinkling_moment(std::int32_t material, double moment) {
  Impl& s = *impl_;
  if (moment == s.forces.wrinkling().moment(material)) return;
  const double before = s.forces.wrinkling_energy();
  s.forces.wrinkling().set_moment(material, moment);
  s.forces.forget();
  s.energies.add_input(s.forces.wrinkling_energy() - before);
}
void CableSystem::release(std::int32_t body) {
  for (LockedBodies& lock : impl_->state.locks) {
    if (lock.carried() != body || !lock.is_locked()) continue;
    lock.release();
    impl_->energies.forget_audit();
  }
}
bool CableSystem::is_held(std::int32_t body) const {
  const LockedBodies* lock = impl_->state.lock_of(static_cast<std::size_t>(body));
  return lock != nullptr && lock->carried() == body;
}
void CableSystem::set_friction(double coefficient) {
  if (coefficient == impl_->contacts.friction()) return;
  impl_->contacts.set_friction(coefficient);
  impl_->forces.forget();
}

const Eigen::Vector3d& CableSystem::contact_impulse(std::int32_t body) const { return impl_->contacts.impulse(body); }
const Eigen::Vector3d& CableSystem::body_contact_impulse(std::int32_t body) const {
  return impl_->contacts.body_impulse(body);
}
BodyContactSum CableSystem::body_contacts() const {
  const BodyContact* contacts = impl_->contacts.of_bodies();
  if (contacts == nullptr) return {};
  const BodyContact::Power power = contacts->power(impl_->state.bodies);
  return {contacts->count(),
          contacts->total_normal_force(),
          contacts->deepest_penetration(),
          contacts->stored_energy(),
          power.damping,
          power.friction};
}
CordContactSum CableSystem::cord_contacts() const {
  const CordContact* contacts = impl_->contacts.of_cords();
  if (contacts == nullptr) return {};
  return {contacts->count(), contacts->total_normal_force(), contacts->deepest_part().part};
}
double CableSystem::penetration() const { return impl_->contacts.with_bodies().deepest_penetration(); }
double CableSystem::contact_compression() const { return impl_->contacts.with_bodies().largest_compression(); }
bool CableSystem::keeps_contacts(double dt) const { return impl_->contacts.fits(dt); }
double CableSystem::contact_step() const { return impl_->contacts.reference_step(); }
void CableSystem::note_shortened_step() { ++impl_->safeguards.shortened_steps; }
const SafeguardCounts& CableSystem::safeguards() const { return impl_->safeguards; }
std::string CableSystem::deepest_contact() const {
  const auto contact = impl_->contacts.with_bodies().deepest_contact();
  if (!contact) return "";
  const Model& model = impl_->model;
  return fmt::format("{} (element {}) is pressed {:.2g} m into the {}",
                     model.threads[model.elements[contact->element].thread], contact->element, contact->penetration,
                     model.bodies[contact->body].name);
}
ContactDepths CableSystem::take_deepest_contacts() { return std::exchange(impl_->contacts.depths(), {}); }

void CableSystem::visit_state(const std::function<void(double&)>& visit) { impl_->visit_state(visit); }

EnergyAudit CableSystem::audit() {
  if (!impl_->energies.is_audited()) impl_->keep_forces_current();
  return impl_->energies.audit();
}

double CableSystem::aliased_energy(double dt) {
  impl_->keep_forces_current();
  return impl_->integrator.aliased_energy(impl_->integrator.velocities_after(0.5 * dt));
}

EnergyAudit CableSystem::capture(Snapshot& snapshot) {
  const Impl& s = *impl_;
  const EnergyAudit energies = audit();
  snapshot.time = s.state.time;
  snapshot.step = s.state.steps;
  const CoordinateLayout& layout = s.state.layout;
  copy_coordinates(s.state.coordinates, layout.position(0), layout.node_count, snapshot.positions);
  copy_coordinates(s.state.velocities, layout.position(0), layout.node_count, snapshot.velocities);
  copy_coordinates(s.state.coordinates, layout.gradient(0), layout.gradient_count, snapshot.gradients);
  snapshot.tension.resize(static_cast<Eigen::Index>(s.model.elements.size()));
  snapshot.strain.resize(static_cast<Eigen::Index>(s.model.elements.size()));
  for (std::size_t i = 0; i < s.model.elements.size(); ++i) {
    snapshot.tension[static_cast<Eigen::Index>(i)] = s.element_states.tension(i);
    snapshot.strain[static_cast<Eigen::Index>(i)] = s.element_states.strain(i);
  }
  snapshot.rope_element_length.clear();
  for (std::int32_t rope = 0; rope < s.elements.ropes().rope_count(); ++rope) {
    snapshot.rope_element_length.push_back(s.elements.ropes().element_length(rope));
  }
  snapshot.bodies.clear();
  for (const DynamicBody& body : s.state.bodies) snapshot.bodies.push_back(body.state());
  snapshot.contacts = s.contacts.with_bodies().contacts();
  if (const BodyContact* of_bodies = s.contacts.of_bodies()) of_bodies->append_points(snapshot.contacts);
  return energies;
}

}  // namespace netpocket
