#include "engine/dynamics/system/cable_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/dynamics/system/cable_system_impl.h"
#include "engine/dynamics/system/symmetric_sector.h"

namespace netpocket {
namespace {

// A speed above this (m/s) is a failure of the integration, not a motion.
constexpr double kRunawaySpeed = 1e5;
// Number of coordinates that a thread examines at once.
constexpr int kSoundRange = 8192;

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

// The state of one sector. Its bodies have the mass of all that is attached to them in the whole.
CableState CableSystem::Impl::sector_state(const Model& model, std::span<const double> mass, const Origin& origin) {
  CableState state(model, mass);
  const SectorModel& sector = origin.sector;
  const CoordinateLayout whole = origin.whole.layout;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    state.bodies[b] = origin.whole.bodies[b];
    std::vector<DynamicBody::Attachment> attachments;
    for (DynamicBody::Attachment attachment : origin.whole.bodies[b].attachments()) {
      const auto& of_whole = attachment.direction ? sector.gradient_of : sector.node_of;
      const std::int32_t index = attachment.coordinate - (attachment.direction ? whole.gradient(0) : whole.position(0));
      for (std::size_t i = 0; i < of_whole.size(); ++i) {
        if (of_whole[i] != index) continue;
        const auto place = static_cast<std::int32_t>(i);
        attachment.coordinate = attachment.direction ? state.layout.gradient(place) : state.layout.position(place);
        attachments.push_back(attachment);
      }
    }
    state.bodies[b].reduce_attachments(std::move(attachments));
    state.bodies[b].move_attachments(state.coordinates, state.velocities);
  }
  return state;
}

CableSystem::Impl::Impl(Model&& source, const SystemOptions& options, const Origin* origin)
    : model(std::move(source)),
      threads(model.elements.size(), options.threads),
      ties(origin ? std::optional<TiedCoordinates>(std::in_place, origin->sector, layout_of(model)) : std::nullopt),
      elements(model, options.evaluation, ties ? &*ties : nullptr),
      state(origin ? sector_state(model, elements.mass(), *origin) : CableState(model, elements.mass())),
      element_states(model, elements, state, threads),
      travelled(model, elements, state, threads),
      ring_ropes(model, state.layout),
      contacts(model, elements, state, threads, ties ? ties->sectors() : 1),
      forces(model, elements, state, ring_ropes, contacts, travelled, threads, ties ? &*ties : nullptr),
      integrator(model, elements, state, forces, threads, travelled.weights(), ties ? &*ties : nullptr),
      energies(elements, state, ring_ropes, contacts, forces, element_states, integrator, ties ? ties->sectors() : 1) {
  ring_ropes.stretch(state.coordinates);
  begin_account();
}
CableSystem::Impl::~Impl() = default;

CableSystem::Impl& CableSystem::Impl::running() { return sector && sector->is_active() ? sector->part() : *this; }
void CableSystem::Impl::leave_symmetry(const std::string& reason) {
  if (sector) sector->leave(reason);
}

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
void CableSystem::Impl::fit_contacts(double dt, double spring_step) {
  if (contacts.fits(spring_step)) return;
  forces.keep_current(dt);
  const double before = contacts.energy_with_bodies();
  contacts.fit_stiffness(spring_step);
  forces.compute(dt);
  energies.add_spent_in_contacts(std::max(before - contacts.energy_with_bodies(), 0.0));
}

void CableSystem::Impl::step(double dt, double spring_step) {
  fix_contacts(dt);
  fit_contacts(dt, spring_step);
  forces.keep_for_step(dt);
  const double kick = integrator.kick(dt);
  const SafeguardCounts before = safeguards;
  energies.before_step(kick);
  safeguards += forces.hinge_safeguards();
  energies.add_spent_in_contacts(contacts.note_step(kick, safeguards));
  const auto fastest = integrator.move(state.velocities, state.coordinates, kick, dt);
  if (ties) safeguards = before + (safeguards - before) * ties->sectors();
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

EnergyAudit CableSystem::Impl::audit() {
  if (!energies.is_audited()) keep_forces_current();
  return energies.audit();
}

EnergyAudit CableSystem::Impl::capture(Snapshot& snapshot) {
  const Impl& s = *this;
  const EnergyAudit audited = audit();
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
  return audited;
}

CableSystem::CableSystem(Model model, const SystemOptions& options) {
  if (const auto fault = model.find_fault()) throw std::invalid_argument(*fault);
  impl_ = std::make_unique<Impl>(std::move(model), options);
  if (options.sectors > 0) impl_->sector = std::make_unique<SymmetricSector>(*impl_, options.sectors);
}
CableSystem::~CableSystem() = default;
CableSystem::CableSystem(CableSystem&&) noexcept = default;
CableSystem& CableSystem::operator=(CableSystem&&) noexcept = default;

const Model& CableSystem::model() const { return impl_->model; }
double CableSystem::time() const { return impl_->running().state.time; }
std::int64_t CableSystem::steps() const { return impl_->running().state.steps; }
double CableSystem::helpers_cpu_seconds() const { return impl_->threads.helpers_cpu_seconds(); }
ElementEvaluation CableSystem::evaluation() const {
  return impl_->elements.is_full() ? ElementEvaluation::full : ElementEvaluation::mean_strain;
}
SymmetryStatus CableSystem::symmetry() const { return impl_->sector ? impl_->sector->status() : SymmetryStatus{}; }
void CableSystem::step(double dt, double spring_step) {
  if (impl_->sector && impl_->sector->is_active()) {
    impl_->sector->step(dt, spring_step);
    if (impl_->sector->is_active()) return;
  }
  impl_->step(dt, spring_step);
}

StableStep CableSystem::stable_step() {
  // Of the whole also while a sector stands for it, so that both runs choose the same steps.
  if (impl_->sector) impl_->sector->unfold();
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
  Impl& s = impl_->running();
  s.elements.update_ropes();
  return s.element_states.stable_step(straight);
}

std::optional<std::string> CableSystem::fault() const {
  if (!impl_->running().looks_sound()) impl_->leave_symmetry("the state is not sound");
  const Impl& s = impl_->running();
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
  if (&impl_->running() != impl_.get()) return impl_->sector->position(node);
  return impl_->state.coordinates.get(impl_->state.layout.position(node));
}
Eigen::Vector3d CableSystem::velocity(std::int32_t node) const {
  if (&impl_->running() != impl_.get()) return impl_->sector->velocity(node);
  return impl_->state.velocities.get(impl_->state.layout.position(node));
}
Eigen::Vector3d CableSystem::gradient(std::int32_t gradient) const {
  if (&impl_->running() != impl_.get()) return impl_->sector->gradient(gradient);
  return impl_->state.coordinates.get(impl_->state.layout.gradient(gradient));
}
BodyState CableSystem::body(std::int32_t body) const { return impl_->running().state.bodies[body].state(); }
RigidMotion CableSystem::motion(std::int32_t body) const { return impl_->running().state.bodies[body].motion(); }
const Wrench& CableSystem::exerted(std::int32_t body) const { return impl_->running().state.bodies[body].exerted(); }
const RopeMotion& CableSystem::rope_motion(std::int32_t rope) const {
  const auto ring_rope = impl_->ring_rope(rope);
  if (ring_rope) return impl_->ring_ropes.motion(*ring_rope);
  Impl& s = impl_->running();
  return s.elements.ropes().motion(&s == impl_.get() ? rope : impl_->sector->rope_of(rope));
}
double CableSystem::rope_tension(std::int32_t rope) const {
  const auto ring_rope = impl_->ring_rope(rope);
  if (ring_rope) return impl_->ring_ropes.tension(*ring_rope);
  Impl& s = impl_->running();
  return s.element_states.rope_tension(&s == impl_.get() ? rope : impl_->sector->rope_of(rope));
}
void CableSystem::rope_tensions(std::span<double> tensions) const {
  const std::size_t wound = std::min(tensions.size(), static_cast<std::size_t>(impl_->elements.ropes().rope_count()));
  if (&impl_->running() == impl_.get()) {
    impl_->element_states.rope_tensions(tensions.first(wound));
  } else {
    for (std::size_t rope = 0; rope < wound; ++rope) tensions[rope] = rope_tension(static_cast<std::int32_t>(rope));
  }
  for (std::size_t rope = wound; rope < tensions.size(); ++rope) {
    tensions[rope] = impl_->ring_ropes.tension(rope - wound);
  }
}
std::vector<double> CableSystem::ring_rope_lengths(std::int32_t ring_rope) const {
  return impl_->ring_ropes.lengths(static_cast<std::size_t>(ring_rope));
}
std::vector<double> CableSystem::ring_rope_tensions(std::int32_t ring_rope) const {
  return impl_->ring_ropes.tensions(static_cast<std::size_t>(ring_rope));
}

void CableSystem::displace(std::span<const Eigen::Vector3d> displacements) {
  impl_->leave_symmetry("nodes are displaced");
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
  if (impl_->sector && impl_->sector->is_active()) impl_->sector->control(body, control);
  Impl& s = impl_->running();
  s.state.controls[body] = control;
  s.energies.forget_audit();
  if (s.contacts.depend_on_controls()) s.forces.forget();
}
void CableSystem::wind(std::int32_t rope, const RopeMotion& motion) {
  if (const auto ring_rope = impl_->ring_rope(rope)) {
    impl_->ring_ropes.wind(*ring_rope, motion);
  } else if (impl_->sector && impl_->sector->is_active()) {
    impl_->sector->wind(rope, motion);
  } else {
    impl_->elements.ropes().wind(rope, motion);
  }
}
void CableSystem::set_wrinkling_moment(std::int32_t material, double moment) {
  Impl& s = impl_->running();
  if (moment == s.forces.wrinkling().moment(material)) return;
  if (&s != impl_.get()) return impl_->sector->set_wrinkling_moment(material, moment);
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
  Impl& s = impl_->running();
  if (coefficient == s.contacts.friction()) return;
  s.contacts.set_friction(coefficient);
  s.forces.forget();
}

const Eigen::Vector3d& CableSystem::contact_impulse(std::int32_t body) const {
  return impl_->running().contacts.impulse(body);
}
const Eigen::Vector3d& CableSystem::body_contact_impulse(std::int32_t body) const {
  return impl_->running().contacts.body_impulse(body);
}
BodyContactSum CableSystem::body_contacts() const {
  const BodyContact* contacts = impl_->running().contacts.of_bodies();
  if (contacts == nullptr) return {};
  const BodyContact::Power power = contacts->power(impl_->running().state.bodies);
  return {contacts->count(),
          contacts->total_normal_force(),
          contacts->deepest_penetration(),
          contacts->stored_energy(),
          power.damping,
          power.friction};
}
CordContactSum CableSystem::cord_contacts() const {
  const CordContact* contacts = impl_->running().contacts.of_cords();
  if (contacts == nullptr) return {};
  return {contacts->count(), contacts->total_normal_force(), contacts->deepest_part().part};
}
double CableSystem::penetration() const { return impl_->running().contacts.with_bodies().deepest_penetration(); }
double CableSystem::contact_squared_phase() const {
  return impl_->running().contacts.with_bodies().largest_squared_phase();
}
double CableSystem::contact_compression() const {
  return impl_->running().contacts.with_bodies().largest_compression();
}
double CableSystem::contact_load() { return impl_->running().contacts.largest_load(); }
double CableSystem::contact_step() const { return impl_->running().contacts.reference_step(); }
void CableSystem::note_shortened_step() { ++impl_->running().safeguards.shortened_steps; }
const SafeguardCounts& CableSystem::safeguards() const { return impl_->running().safeguards; }
std::string CableSystem::deepest_contact() const {
  auto contact = impl_->running().contacts.with_bodies().deepest_contact();
  if (!contact) return "";
  if (&impl_->running() != impl_.get()) contact->element = impl_->sector->element_of(contact->element);
  const Model& model = impl_->model;
  return fmt::format("{} (element {}) is pressed {:.2g} m into the {}",
                     model.threads[model.elements[contact->element].thread], contact->element, contact->penetration,
                     model.bodies[contact->body].name);
}
ContactDepths CableSystem::take_deepest_contacts() {
  ContactDepths depths = std::exchange(impl_->running().contacts.depths(), {});
  if (&impl_->running() == impl_.get()) return depths;
  impl_->sector->note_change();
  for (ContactDepth* depth : {&depths.pressed, &depths.overlapping}) {
    depth->element = impl_->sector->element_of(depth->element);
  }
  return depths;
}

void CableSystem::visit_state(const std::function<void(double&)>& visit) {
  if (impl_->sector) {
    impl_->sector->visit_state(visit);
  } else {
    impl_->visit_state(visit);
  }
}

EnergyAudit CableSystem::audit() { return impl_->running().audit(); }

double CableSystem::aliased_energy(double dt) {
  Impl& s = impl_->running();
  s.keep_forces_current();
  const double energy = s.integrator.aliased_energy(s.integrator.velocities_after(0.5 * dt));
  return s.ties ? s.ties->sectors() * energy : energy;
}

EnergyAudit CableSystem::capture(Snapshot& snapshot) {
  Impl& s = impl_->running();
  if (&s == impl_.get()) return s.capture(snapshot);
  Snapshot of_sector;
  const EnergyAudit energies = s.capture(of_sector);
  impl_->sector->unfold(of_sector, snapshot);
  return energies;
}

}  // namespace netpocket
