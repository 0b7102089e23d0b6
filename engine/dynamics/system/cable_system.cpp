#include "engine/dynamics/system/cable_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "engine/ancf/mass.h"
#include "engine/ancf/strain_pair.h"
#include "engine/dynamics/system/cable_system_impl.h"

namespace netpocket {
namespace {

// With fewer elements than this, a second thread costs more time than it saves.
constexpr std::size_t kFewestElementsForThreads = 8000;
// A speed above this (m/s) is a failure of the integration, not a motion.
constexpr double kRunawaySpeed = 1e5;

// For messages. Of a runaway only the order of magnitude matters.
std::string speed_text(double speed) {
  return speed < kRunawaySpeed ? fmt::format("{:.3g} m/s", speed) : fmt::format("{:.3g} km/s", speed / 1000);
}

}  // namespace

std::vector<BatchElement> CableSystem::Impl::batch_elements() const {
  std::vector<BatchElement> elements;
  elements.reserve(model.elements.size());
  for (const ModelElement& e : model.elements) {
    elements.push_back({{layout.position(e.node1), layout.gradient(e.gradient1), layout.position(e.node2),
                         layout.gradient(e.gradient2)},
                        e.length,
                        model.materials[e.material].section,
                        false,
                        options.evaluation == ElementEvaluation::mean_strain ? e.strain_partner : -1});
  }
  for (const VariableRope& rope : model.ropes) {
    for (const std::int32_t element : rope.elements) elements[element].variable = true;
  }
  return elements;
}

CableSystem::Impl::Impl(Model&& source, const SystemOptions& opts)
    : model(std::move(source)),
      options(opts),
      team(model.elements.size() < kFewestElementsForThreads || opts.threads < 2
               ? nullptr
               : std::make_unique<ThreadTeam>(opts.threads)),
      layout{static_cast<std::int32_t>(model.nodes.size()), static_cast<std::int32_t>(model.gradients.size())},
      coordinates(layout.size()),
      velocities(layout.size()),
      batch(batch_elements()),
      full_batch(batch.block_count()),
      assembly(batch_elements(), layout.size(), team ? options.threads : 1),
      mass(layout.size(), 0.0),
      inverse_mass(layout.size(), 0.0),
      moving_mass(layout.size(), 0.0),
      unmoved(layout.size()),
      friction(model.contact.friction),
      ropes(model, layout),
      wrinkling(model, batch_elements(), opts.evaluation == ElementEvaluation::full),
      contacts(model, layout),
      contacted(layout.size()),
      motion(model),
      element_forces(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize, 0.0),
      applied(layout.size()) {
  for (const CableMaterial& material : model.materials) {
    wave_speed.push_back(std::sqrt(material.section.EA / material.section.mass_per_length));
  }
  element_length.resize(model.elements.size());
  wave_rate.resize(static_cast<std::size_t>(batch.block_count()) * kBlockSize, 0.0);
  unpaired_rate = wave_rate;
  for (std::size_t i = 0; i < model.elements.size(); ++i) set_length(i, model.elements[i].length);
  set_initial_state();
  collect_mass();
  collect_hinges();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    bodies.emplace_back(model, static_cast<std::int32_t>(b), layout, mass);
    bodies.back().move_attachments(coordinates, velocities);
    std::set<std::int32_t> blocks;
    for (const DynamicBody::Attachment& attachment : bodies.back().attachments()) {
      blocks.insert(attachment.coordinate / kBlockSize);
    }
    attached_blocks.emplace_back(blocks.begin(), blocks.end());
  }
  bodies_way.assign(bodies.size(), 0.0);
  for (const DynamicBody& body : bodies) attachments_reach.push_back(reach_of_attachments(body));
  controls.resize(bodies.size());
  wrenches.resize(bodies.size());
  impulses.assign(bodies.size(), Eigen::Vector3d::Zero());
  body_impulses = impulses;
  if (model.contact.cords) cord_contacts = std::make_unique<CordContact>(model, layout, coordinates, inverse_mass);
  set_constant_loads();
  if (options.evaluation == ElementEvaluation::full) {
    consistent_mass.emplace(model, layout, mass, ropes.massive_coordinates());
    unit_mass.assign(layout.size(), 1.0);
    forces = CoordinateVectors(layout.size());
  }
  if (model.contact.bodies && bodies.size() > 1) body_contacts = std::make_unique<BodyContact>(model, bodies);
  begin_accounts();
}

// Largest distance (m) that a point of a cord moves per radian of the body's rotation: the farthest attached node, plus
// the effect of a rotating attached gradient on the curve, at most a quarter of the longest element times the gradient.
double CableSystem::Impl::reach_of_attachments(const DynamicBody& body) const {
  double longest = 0, farthest = 0, steepest = 0;
  for (const double length : element_length) longest = std::max(longest, length);
  for (const DynamicBody::Attachment& attachment : body.attachments()) {
    double& largest = attachment.direction ? steepest : farthest;
    largest = std::max(largest, attachment.local.norm());
  }
  return farthest + 0.25 * longest * steepest;
}

// Called again when a system is displaced or its springs change before the first step: accounts then begin at that
// state.
void CableSystem::Impl::begin_accounts() {
  initial_input = 0;
  compute_forces(1e-4);
  const EnergyAudit start = audit();
  initial_energy = start.kinetic + start.strain + start.contact;
  initial_input = start.input;
  step_of_audit = -1;  // that audit did not yet know the initial energy
}

void CableSystem::Impl::set_initial_state() {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    coordinates.set(layout.position(static_cast<std::int32_t>(i)), model.nodes[i].position);
    if (model.nodes[i].support == Support::free) {
      velocities.set(layout.position(static_cast<std::int32_t>(i)), model.nodes[i].velocity);
    }
  }
  for (std::size_t i = 0; i < model.gradients.size(); ++i) {
    coordinates.set(layout.gradient(static_cast<std::int32_t>(i)), model.gradients[i].value);
    if (model.gradients[i].support == Support::free) {
      velocities.set(layout.gradient(static_cast<std::int32_t>(i)), model.gradients[i].rate);
    }
  }
}

void CableSystem::Impl::collect_mass() {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    mass[layout.position(static_cast<std::int32_t>(i))] = model.nodes[i].point_mass;
  }
  for (const BatchElement& element : batch_elements()) {
    if (element.variable) continue;
    NodalWeights lump = lumped_mass(element.section.mass_per_length, element.length);
    if (element.strain_partner >= 0) move_from_middle(lump, ends_at_strain_partner(element));
    for (int corner = 0; corner < 4; ++corner) mass[element.coordinate[corner]] += lump[corner];
  }
  for (const std::int32_t coordinate : ropes.massive_coordinates()) mass_without_ropes.push_back(mass[coordinate]);
  update_ropes();
  for (std::int32_t coordinate = 0; coordinate < layout.size(); ++coordinate) {
    if (!moves(coordinate) || mass[coordinate] <= 0) continue;
    inverse_mass[coordinate] = 1 / mass[coordinate];
    moving_mass[coordinate] = mass[coordinate];
  }
}

// Keeps the hinges' order and begins a new block wherever the body that keeps the hinge plane changes.
void CableSystem::Impl::collect_hinges() {
  for (const Hinge& hinge : model.hinges) {
    if (hinges.empty() || hinges.back().body != hinge.body || hinges.back().count == kBlockSize) {
      hinges.emplace_back();
      hinges.back().body = hinge.body;
    }
    HingeBlock& block = hinges.back();
    // Fill the unused lanes with this hinge too. Their results are ignored.
    for (int lane = block.count; lane < kBlockSize; ++lane) {
      for (int i = 0; i < 9; ++i) block.rest_rotation[i][lane] = hinge.rest_rotation.data()[i];
      block.stiffness[lane] = hinge.stiffness;
      block.damping[lane] = hinge.damping;
      block.gradient1[lane] = layout.gradient(hinge.gradient1);
      block.gradient2[lane] = layout.gradient(hinge.gradient2);
    }
    ++block.count;
  }
}

// Whether the element's second node is the middle node of its pair.
bool CableSystem::Impl::ends_at_strain_partner(const BatchElement& element) const {
  return element.coordinate[2] == coordinate(static_cast<std::size_t>(element.strain_partner), 0);
}

bool CableSystem::Impl::moves(std::int32_t coordinate) const {
  if (coordinate < layout.node_count) return model.nodes[coordinate].support == Support::free;
  const std::int32_t gradient = coordinate - layout.gradient(0);
  return gradient >= 0 && gradient < layout.gradient_count && model.gradients[gradient].support == Support::free;
}

void CableSystem::Impl::set_length(std::size_t element, double length) {
  element_length[element] = length;
  const double rate = wave_speed[model.elements[element].material] / length;
  wave_rate[element] = rate * rate;
  if (model.elements[element].strain_partner < 0) unpaired_rate[element] = rate * rate;
}

// Brings the lengths and masses of ropes to their present motion.
void CableSystem::Impl::update_ropes() {
  if (ropes.empty() || !ropes.refresh_spans()) return;
  for (std::size_t i = 0; i < mass_without_ropes.size(); ++i) {
    mass[ropes.massive_coordinates()[i]] = mass_without_ropes[i];
  }
  ropes.update(batch, mass);
  for (const std::int32_t coordinate : ropes.massive_coordinates()) {
    if (inverse_mass[coordinate] == 0) continue;
    inverse_mass[coordinate] = 1 / mass[coordinate];
    moving_mass[coordinate] = mass[coordinate];
  }
  for (std::int32_t rope = 0; rope < ropes.rope_count(); ++rope) {
    for (const std::int32_t element : model.ropes[rope].elements) {
      set_length(static_cast<std::size_t>(element), ropes.element_length(rope));
      full_batch.set_start_rate(element, ropes.span_of(element)->start_rate);
    }
  }
}

void CableSystem::Impl::set_constant_loads() {
  CoordinateVectors load(layout.size());
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const ModelNode& node = model.nodes[i];
    load.set(layout.position(static_cast<std::int32_t>(i)), node.load + node.point_mass * model.gravity);
  }
  for (const BatchElement& element : batch_elements()) {
    NodalWeights weight = uniform_load(element.length);
    if (element.strain_partner >= 0 && !element.variable) move_from_middle(weight, ends_at_strain_partner(element));
    for (int corner = 0; corner < 4; ++corner) {
      load.add(element.coordinate[corner], element.section.mass_per_length * weight[corner] * model.gravity);
    }
  }
  applied.set_constant(std::move(load));
}

ElementCoordinates CableSystem::Impl::gather(const CoordinateVectors& vectors, std::size_t element) const {
  ElementCoordinates q;
  for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(coordinate(element, corner));
  return q;
}

MaterialSpan CableSystem::Impl::span(std::size_t element) const {
  const MaterialSpan* variable = ropes.span_of(static_cast<std::int32_t>(element));
  return variable != nullptr ? *variable : MaterialSpan{.length = element_length[element]};
}

CableSystem::CableSystem(Model model, const SystemOptions& options) {
  if (const auto fault = model.find_fault()) throw std::invalid_argument(*fault);
  impl_ = std::make_unique<Impl>(std::move(model), options);
}
CableSystem::~CableSystem() = default;
CableSystem::CableSystem(CableSystem&&) noexcept = default;
CableSystem& CableSystem::operator=(CableSystem&&) noexcept = default;

const Model& CableSystem::model() const { return impl_->model; }
double CableSystem::time() const { return impl_->time; }
std::int64_t CableSystem::steps() const { return impl_->steps; }
double CableSystem::helpers_cpu_seconds() const { return impl_->team ? impl_->team->members_cpu_seconds() : 0; }
ElementEvaluation CableSystem::evaluation() const { return impl_->options.evaluation; }
void CableSystem::step(double dt) { impl_->step(dt); }

StableStep CableSystem::stable_step() {
  impl_->update_ropes();  // until now they have the length of the last step's start
  std::vector<BatchElement> now = impl_->batch_elements();
  for (std::size_t i = 0; i < now.size(); ++i) now[i].length = impl_->element_length[i];
  if (impl_->consistent_mass) return find_stable_step_of_full_elements(impl_->model, now, impl_->coordinates);
  return find_stable_step(impl_->model, impl_->layout, now, impl_->inverse_mass, impl_->coordinates);
}

// Two effects raise the frequencies above those of straight cables.
// - Bends: stretching also acts on the gradients of a bent element, and the two elements of a pair no longer cancel
//   where they meet at an angle. Let K_1 and K_2 have the largest squared frequencies l_1 and l_2. Then K_1 + K_2 has
//   (l_1 + l_2)/2 + sqrt((l_1 - l_2)^2/4 + o l_1 l_2), where o <= 1 is the overlap of the two modes. Power iteration on
//   shapes of captures gives o = 0.03 for paired elements, with l_2 as large as it is taken here. Elements without a
//   strain partner get o = 1: a bent one vibrates as a whole.
// - Tension: at strain eps the Green strain's stiffness along a cord is EA (1 + 2 eps) + N = EA (1 + 3 eps).
double CableSystem::stable_step_as_bent(const StableStep& straight) {
  Impl& s = *impl_;
  if (straight.stiffness == 0) return straight.step;
  s.update_ropes();
  if (s.consistent_mass) return s.stable_step_as_stretched(straight);
  if (s.step_of_states != s.steps) s.compute_states();
  struct Largest {
    double of_bends = 0, of_unpaired = 0, strain = 0;
  };
  using Row = Eigen::Array<double, kBlockSize, 1>;
  const auto largest = [&](int first, int last) {
    Row of_bends = Row::Zero(), of_unpaired = Row::Zero(), strain = Row::Zero();
    for (int block = first; block < last; ++block) {
      const Eigen::Map<const Row> rate(&s.wave_rate[static_cast<std::size_t>(block) * kBlockSize]);  // 0: no element
      const Eigen::Map<const Row> unpaired(&s.unpaired_rate[static_cast<std::size_t>(block) * kBlockSize]);
      const Eigen::Map<const Row> bend(s.state_row(block, kBendStiffness));
      of_bends = of_bends.max(rate * bend);
      of_unpaired = of_unpaired.max(unpaired * bend);
      strain = strain.max((rate > 0).select(Eigen::Map<const Row>(s.state_row(block, kStrain)), 0.0));
    }
    return Largest{of_bends.maxCoeff(), of_unpaired.maxCoeff(), strain.maxCoeff()};
  };
  double of_bends = 0, of_unpaired = 0, strain = 0;
  for (const Largest& part :
       values_of_ranges<Largest>(s.loop(), s.batch.block_count(), kElementRange / kBlockSize, largest)) {
    of_bends = std::max(of_bends, part.of_bends);
    of_unpaired = std::max(of_unpaired, part.of_unpaired);
    strain = std::max(strain, part.strain);
  }
  const double bent = of_bends / straight.stiffness;
  // At 1 the bound is sure. Cords strained by more than some percent need that.
  const double overlap = std::clamp(10 * strain - 0.5, 0.25, 1.0);
  const double paired = 0.5 * (1 + bent + std::sqrt((1 - bent) * (1 - bent) + 4 * overlap * bent));
  const double together = std::max(paired, 1 + of_unpaired / straight.stiffness);
  // Damping of stretching grows in proportion to its stiffness.
  const double ratio = together + 3 * strain;
  return stable_step_of_mode(straight.stiffness * ratio, straight.damping * ratio);
}

// Whether every number is finite and no element end can exceed kRunawaySpeed. A cheap test that errs on the safe side.
bool CableSystem::Impl::looks_sound() {
  double longest = 1;
  for (const double length : element_length) longest = std::max(longest, length);
  const double limit = kRunawaySpeed * kRunawaySpeed / (longest * longest);
  const auto are_sound = [&](int first, int last) -> char {
    return std::isfinite(largest_square(coordinates.squared_norms(first, last - first))) &&
                   largest_square(velocities.squared_norms(first, last - first)) < limit
               ? 1
               : 0;
  };
  const auto sound = values_of_ranges<char>(loop(), layout.size(), kCoordinateRange, are_sound);
  return std::ranges::all_of(sound, [](char part) { return part != 0; });
}

std::optional<std::string> CableSystem::fault() const {
  Impl& s = *impl_;
  const std::size_t suspects = s.looks_sound() ? 0 : s.model.elements.size();
  for (std::size_t i = 0; i < suspects; ++i) {
    for (int corner = 0; corner < 4; ++corner) {
      const std::int32_t coordinate = s.coordinate(i, corner);
      const double speed = s.velocities.get(coordinate).norm() * (corner % 2 == 0 ? 1.0 : s.element_length[i]);
      if (speed < kRunawaySpeed && s.coordinates.get(coordinate).allFinite()) continue;
      return fmt::format("{} (element {}){} moves at {}", s.model.threads[s.model.elements[i].thread], i,
                         s.contact_of(static_cast<std::int32_t>(i)), speed_text(speed));
    }
  }
  for (std::size_t b = 0; b < s.bodies.size(); ++b) {
    const RigidBody& body = s.bodies[b].rigid();
    if (body.position().allFinite() && body.velocity().norm() < kRunawaySpeed && body.angular_momentum().allFinite())
      continue;
    return fmt::format("the {} moves at {}", s.model.bodies[b].name, speed_text(body.velocity().norm()));
  }
  return std::nullopt;
}

Eigen::Vector3d CableSystem::position(std::int32_t node) const {
  return impl_->coordinates.get(impl_->layout.position(node));
}
Eigen::Vector3d CableSystem::velocity(std::int32_t node) const {
  return impl_->velocities.get(impl_->layout.position(node));
}
Eigen::Vector3d CableSystem::gradient(std::int32_t gradient) const {
  return impl_->coordinates.get(impl_->layout.gradient(gradient));
}
BodyState CableSystem::body(std::int32_t body) const { return impl_->bodies[body].state(); }
RigidMotion CableSystem::motion(std::int32_t body) const { return impl_->bodies[body].motion(); }
const Wrench& CableSystem::exerted(std::int32_t body) const { return impl_->bodies[body].exerted(); }
const RopeMotion& CableSystem::rope_motion(std::int32_t rope) const { return impl_->ropes.motion(rope); }

void CableSystem::displace(std::span<const Eigen::Vector3d> displacements) {
  for (std::size_t i = 0; i < displacements.size(); ++i) {
    if (impl_->model.nodes[i].support != Support::free) continue;
    impl_->coordinates.add(impl_->layout.position(static_cast<std::int32_t>(i)), displacements[i]);
  }
  impl_->state_has_jumped();
  impl_->begin_accounts();
}
void CableSystem::control(std::int32_t body, const BodyControl& control) {
  impl_->controls[body] = control;
  impl_->step_of_audit = -1;
  // The contact forces of bodies depend on the motion that their controls impose.
  if (impl_->body_contacts && impl_->body_contacts->count() > 0) impl_->forget_forces();
}
void CableSystem::wind(std::int32_t rope, const RopeMotion& motion) { impl_->ropes.wind(rope, motion); }
void CableSystem::set_wrinkling_moment(std::int32_t material, double moment) {
  if (moment == impl_->wrinkling.moment(material)) return;
  const double before = impl_->wrinkling.energy(impl_->coordinates);
  impl_->wrinkling.set_moment(material, moment);
  impl_->forget_forces();
  impl_->input_work += impl_->wrinkling.energy(impl_->coordinates) - before;
}
void CableSystem::set_friction(double coefficient) {
  if (coefficient != impl_->friction) impl_->set_friction(coefficient);
}
void CableSystem::Impl::set_friction(double coefficient) {
  friction = coefficient;
  forget_forces();
  contacts.set_friction(coefficient);
  if (cord_contacts) cord_contacts->set_friction(coefficient);
  if (body_contacts) body_contacts->set_friction(coefficient);
}

const Eigen::Vector3d& CableSystem::contact_impulse(std::int32_t body) const { return impl_->impulses[body]; }
const Eigen::Vector3d& CableSystem::body_contact_impulse(std::int32_t body) const { return impl_->body_impulses[body]; }
BodyContactSum CableSystem::body_contacts() const {
  if (!impl_->body_contacts) return {};
  const BodyContact& contacts = *impl_->body_contacts;
  const BodyContact::Power power = contacts.power(impl_->bodies);
  return {contacts.count(),
          contacts.total_normal_force(),
          contacts.deepest_penetration(),
          contacts.stored_energy(),
          power.damping,
          power.friction};
}
CordContactSum CableSystem::cord_contacts() const {
  if (!impl_->cord_contacts) return {};
  return {impl_->cord_contacts->count(), impl_->cord_contacts->total_normal_force(),
          impl_->cord_contacts->deepest_part().part};
}
double CableSystem::penetration() const { return impl_->contacts.deepest_penetration(); }
double CableSystem::contact_step() const { return impl_->reference_step; }
void CableSystem::note_shortened_step() { ++impl_->safeguards.shortened_steps; }
const SafeguardCounts& CableSystem::safeguards() const { return impl_->safeguards; }
std::string CableSystem::deepest_contact() const {
  const auto contact = impl_->contacts.deepest_contact();
  if (!contact) return "";
  const Model& model = impl_->model;
  return fmt::format("{} (element {}) is pressed {:.2g} m into the {}",
                     model.threads[model.elements[contact->element].thread], contact->element, contact->penetration,
                     model.bodies[contact->body].name);
}
ContactDepths CableSystem::take_deepest_contacts() { return std::exchange(impl_->depths, {}); }

void CableSystem::visit_state(const std::function<void(double&)>& visit) {
  Impl& s = *impl_;
  // The state is written only if the visitor changes it: observing the state must not change a bit of the run. Bits are
  // compared because 0.0 and -0.0 compare equal.
  bool changed = false;
  const std::function<void(double&)> visit_number = [&](double& number) {
    const auto before = std::bit_cast<std::uint64_t>(number);
    visit(number);
    changed = changed || std::bit_cast<std::uint64_t>(number) != before;
  };
  const auto visit_vector = [&](auto&& v) {
    const bool changed_before = std::exchange(changed, false);
    for (Eigen::Index i = 0; i < v.size(); ++i) visit_number(v[i]);
    const bool changes = changed;
    changed = changed || changed_before;
    return changes;
  };
  for (CoordinateVectors* vectors : {&s.coordinates, &s.velocities}) {
    for (std::int32_t coordinate = 0; coordinate < s.layout.size(); ++coordinate) {
      Eigen::Vector3d value = vectors->get(coordinate);
      if (visit_vector(value)) vectors->set(coordinate, value);
    }
  }
  for (DynamicBody& body : s.bodies) {
    RigidBodyState state = body.rigid().state();
    bool moved = visit_vector(state.position);
    moved = visit_vector(state.velocity) || moved;
    moved = visit_vector(state.attitude.coeffs()) || moved;
    moved = visit_vector(state.angular_momentum) || moved;
    if (moved) body.rigid().restore(state);
  }
  for (BodyControl& control : s.controls) control.visit_state(visit_number);
  for (Eigen::Vector3d& impulse : s.impulses) visit_vector(impulse);
  double friction = s.friction;
  visit_number(friction);
  if (friction != s.friction) s.set_friction(friction);
  s.wrinkling.visit_state(visit_number);
  double steps = static_cast<double>(s.steps);
  double reference_step = s.reference_step;
  for (double* value :
       {&s.time, &s.last_dt, &steps, &s.input_work, &s.spent.in_cords, &s.spent.at_hinges, &s.spent.in_contacts,
        &s.spent.by_friction, &s.initial_energy, &s.initial_input, &s.depths.penetration, &reference_step}) {
    visit_number(*value);
  }
  if (reference_step != s.reference_step) s.set_reference_step(reference_step);
  s.contacts.visit_state(visit_number);
  s.depths.pressed.visit_state(visit);
  s.depths.overlapping.visit_state(visit);
  s.safeguards.visit_state(visit);
  if (s.body_contacts) {
    for (Eigen::Vector3d& impulse : s.body_impulses) visit_vector(impulse);
    s.body_contacts->visit_state(visit);
  }
  s.ropes.visit_state(visit_number);
  // A file may hold a number that is not a valid count.
  if (steps >= 0 && steps < 9e15) s.steps = static_cast<std::int64_t>(steps);
  if (changed) s.state_has_jumped();
}

// To be called when positions have changed in another way than by a step.
void CableSystem::Impl::state_has_jumped() {
  step_of_states = step_of_speed = -1;
  forget_forces();
  contacts.forget_candidates();
  if (cord_contacts) cord_contacts->forget_candidates();
}

}  // namespace netpocket
