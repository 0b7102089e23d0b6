#include "engine/dynamics/cable_system.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "engine/ancf/full_element.h"
#include "engine/ancf/instruction_set.h"
#include "engine/ancf/mass.h"
#include "engine/ancf/mean_strain_element.h"
#include "engine/bodies/sector_sum.h"
#include "engine/dynamics/assembly.h"
#include "engine/dynamics/consistent_mass.h"
#include "engine/dynamics/contact_solver.h"
#include "engine/dynamics/hinge_forces.h"
#include "engine/dynamics/rope_dynamics.h"

namespace netpocket {
namespace {

// Blocks that one task computes. Fixed, so that sums over tasks do not depend on the number of threads.
constexpr int kChunk = 128;
// Below this number of elements a second thread costs more than it gives.
constexpr std::size_t kFewestElementsForThreads = 10000;
// Speeds beyond this (m/s) are a failure of the integration, not a motion.
constexpr double kRunawaySpeed = 1e4;

slot_kernel::Kernel choose_slot_kernel() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return slot_kernel::avx512::update;
    case InstructionSet::avx2:
      return slot_kernel::avx2::update;
    case InstructionSet::baseline:
      break;
  }
  return slot_kernel::baseline::update;
}

std::vector<BatchElement> batch_elements(const Model& model, const SlotLayout& layout) {
  std::vector<BatchElement> elements;
  elements.reserve(model.elements.size());
  for (const ModelElement& e : model.elements) {
    elements.push_back({{layout.position(e.node1), layout.gradient(e.gradient1), layout.position(e.node2),
                         layout.gradient(e.gradient2)},
                        e.length,
                        model.materials[e.material].section});
  }
  for (const VariableRope& rope : model.ropes) {
    for (const std::int32_t element : rope.elements) elements[element].variable = true;
  }
  return elements;
}

}  // namespace

struct CableSystem::Impl {
  Impl(const Model& model, const SystemOptions& options);

  // State at step n (positions) and n - 1/2 (velocities).
  Model model;
  SystemOptions options;
  tbb::task_arena arena;
  SlotLayout layout;
  SlotVectors coordinates, velocities;
  double time = 0;
  double last_dt = 0;
  std::int64_t steps = 0;

  // Elements and masses.
  std::vector<BatchElement> elements;
  ElementBatch batch;
  Assembly assembly;
  std::vector<double> constant_mass;  // by slot, without ropes
  std::vector<double> mass;           // by slot
  AlignedVector<double> inverse_mass;
  std::vector<double> element_length;
  std::optional<ConsistentMass> consistent_mass;

  // Parts.
  std::vector<DynamicBody> bodies;
  std::vector<BodyControl> controls;
  RopeDynamics ropes;
  ContactSolver contacts;

  // Forces of the present state.
  AlignedVector<double> element_forces;
  SlotVectors applied;                     // all but element forces
  SlotVectors constant_load;               // gravity and loads
  std::vector<std::int32_t> loaded_slots;  // where `applied` may differ from `constant_load`
  std::vector<Wrench> wrenches;            // by body
  double damping_power = 0, hinge_power = 0;
  std::vector<double> chunk_power;

  // Accounts since the start.
  double input_work = 0, dissipated = 0, initial_energy = 0, initial_load_work = 0;
  std::vector<Eigen::Vector3d> impulses;
  double deepest_penetration = 0;

  void set_initial_state();
  void collect_mass();
  void update_ropes();
  bool moves(std::int32_t slot) const;
  void set_constant_loads();
  template <typename Function>
  void for_chunks(int blocks, const Function& function);
  void compute_element_forces();
  void compute_full_forces();
  void clear_applied();
  void add_hinges();
  void compute_forces(double dt);
  void move_slots(double kick, double drift);
  void step(double dt);
  Eigen::Vector3d slot_force(std::int32_t slot) const {
    return assembly.element_force(slot, element_forces.data()) + applied.get(slot);
  }
  Eigen::MatrixX3d all_slot_forces() const;
  std::string contact_of(std::int32_t element) const;
  ElementCoordinates gather(const SlotVectors& vectors, std::size_t element) const;
  MaterialSpan span(std::size_t element) const;
  double strain_energy() const;
  double kinetic_energy() const;
  double load_work() const;
  EnergyAudit audit();
};

CableSystem::Impl::Impl(const Model& source, const SystemOptions& opts)
    : model(source),
      options(opts),
      arena(std::max(1, opts.threads)),
      layout{static_cast<std::int32_t>(source.nodes.size()), static_cast<std::int32_t>(source.gradients.size())},
      coordinates(layout.size()),
      velocities(layout.size()),
      elements(batch_elements(model, layout)),
      batch(elements),
      assembly(elements, layout.size()),
      constant_mass(layout.size(), 0.0),
      mass(layout.size(), 0.0),
      inverse_mass(layout.size(), 0.0),
      ropes(model, layout),
      contacts(model, layout, mass),
      element_forces(static_cast<std::size_t>(batch.block_count()) * kForceRows * kBlockSize, 0.0),
      applied(layout.size()),
      constant_load(layout.size()) {
  for (const ModelElement& element : model.elements) element_length.push_back(element.length);
  set_initial_state();
  collect_mass();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    bodies.emplace_back(model, static_cast<std::int32_t>(b), layout, mass);
    bodies.back().move_attachments(coordinates, velocities);
  }
  controls.resize(bodies.size());
  wrenches.resize(bodies.size());
  impulses.assign(bodies.size(), Eigen::Vector3d::Zero());
  set_constant_loads();
  if (options.evaluation == ElementEvaluation::full) {
    consistent_mass.emplace(model, layout, mass, ropes.massive_slots());
  }
  initial_load_work = load_work();
  compute_forces(1e-4);
  const EnergyAudit start = audit();
  initial_energy = start.kinetic + start.strain;
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
    constant_mass[layout.position(static_cast<std::int32_t>(i))] = model.nodes[i].point_mass;
  }
  for (const BatchElement& element : elements) {
    if (element.variable) continue;
    const NodalWeights lump = lumped_mass(element.section.mass_per_length, element.length);
    for (int corner = 0; corner < 4; ++corner) constant_mass[element.slot[corner]] += lump[corner];
  }
  mass = constant_mass;
  update_ropes();
  for (std::int32_t slot = 0; slot < layout.size(); ++slot) {
    inverse_mass[slot] = moves(slot) && mass[slot] > 0 ? 1 / mass[slot] : 0;
  }
}

bool CableSystem::Impl::moves(std::int32_t slot) const {
  if (slot < layout.node_count) return model.nodes[slot].support == Support::free;
  const std::int32_t gradient = slot - layout.gradient(0);
  return gradient >= 0 && gradient < layout.gradient_count && model.gradients[gradient].support == Support::free;
}

// Brings lengths and masses of ropes to the present time.
void CableSystem::Impl::update_ropes() {
  if (ropes.empty()) return;
  for (const std::int32_t slot : ropes.massive_slots()) mass[slot] = constant_mass[slot];
  ropes.update(time, batch, mass);
  for (const std::int32_t slot : ropes.massive_slots()) {
    if (inverse_mass[slot] != 0) inverse_mass[slot] = 1 / mass[slot];
  }
  for (std::int32_t rope = 0; rope < ropes.rope_count(); ++rope) {
    for (const std::int32_t element : model.ropes[rope].elements) element_length[element] = ropes.element_length(rope);
  }
}

void CableSystem::Impl::set_constant_loads() {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const ModelNode& node = model.nodes[i];
    constant_load.set(layout.position(static_cast<std::int32_t>(i)), node.load + node.point_mass * model.gravity);
  }
  for (const BatchElement& element : elements) {
    const NodalWeights weight = uniform_load(element.length);
    for (int corner = 0; corner < 4; ++corner) {
      constant_load.add(element.slot[corner], element.section.mass_per_length * weight[corner] * model.gravity);
    }
  }
  applied = constant_load;
}

template <typename Function>
void CableSystem::Impl::for_chunks(int blocks, const Function& function) {
  const int chunks = (blocks + kChunk - 1) / kChunk;
  const auto run = [&](int chunk) { function(chunk, chunk * kChunk, std::min(blocks, (chunk + 1) * kChunk)); };
  if (options.threads > 1 && elements.size() >= kFewestElementsForThreads) {
    arena.execute([&] { tbb::parallel_for(0, chunks, run, tbb::static_partitioner()); });
  } else {
    for (int chunk = 0; chunk < chunks; ++chunk) run(chunk);
  }
}

void CableSystem::Impl::compute_element_forces() {
  if (options.evaluation == ElementEvaluation::full) {
    compute_full_forces();
    return;
  }
  chunk_power.assign((batch.block_count() + kChunk - 1) / kChunk, 0.0);
  for_chunks(batch.block_count(), [&](int chunk, int first, int last) {
    chunk_power[chunk] = batch.forces(first, last, coordinates.arrays(), velocities.arrays(), element_forces.data());
  });
  damping_power = 0;
  for (const double power : chunk_power) damping_power += power;
}

void CableSystem::Impl::compute_full_forces() {
  damping_power = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const FullElement element(elements[i].section, span(i));
    const ElementCoordinates q = gather(coordinates, i), velocity = gather(velocities, i);
    const ElementCoordinates force = element.internal_force(q, velocity);
    double* rows = element_forces.data() + i / kBlockSize * kForceRows * kBlockSize + i % kBlockSize;
    const int columns[3] = {0, 1, 3};  // the force on r2 is minus that on r1
    for (int part = 0; part < 3; ++part) {
      for (int axis = 0; axis < 3; ++axis) rows[(3 * part + axis) * kBlockSize] = force(axis, columns[part]);
    }
    damping_power += element.dissipated_power(q, velocity);
  }
}

void CableSystem::Impl::clear_applied() {
  for (const std::int32_t slot : loaded_slots) applied.set(slot, constant_load.get(slot));
  loaded_slots.clear();
  for (Wrench& wrench : wrenches) wrench = Wrench{};
}

void CableSystem::Impl::add_hinges() {
  hinge_power = 0;
  std::vector<SectorSum<Eigen::Vector3d>> torque(bodies.size(), SectorSum<Eigen::Vector3d>(Eigen::Vector3d::Zero()));
  for (std::size_t i = 0; i < model.hinges.size(); ++i) {
    const Hinge& hinge = model.hinges[i];
    const std::int32_t g1 = layout.gradient(hinge.gradient1), g2 = layout.gradient(hinge.gradient2);
    const bool on_body = hinge.body >= 0;
    const HingeForces forces =
        hinge_forces(hinge, coordinates.get(g1), coordinates.get(g2), velocities.get(g1), velocities.get(g2),
                     on_body ? bodies[hinge.body].rigid().rotation() : Eigen::Matrix3d::Identity(),
                     on_body ? bodies[hinge.body].rigid().angular_velocity() : Eigen::Vector3d::Zero());
    applied.add(g1, forces.on_gradient1);
    applied.add(g2, forces.on_gradient2);
    loaded_slots.insert(loaded_slots.end(), {g1, g2});
    if (on_body) torque[hinge.body].add(static_cast<int>(i), forces.torque_on_body);
    hinge_power += forces.dissipated_power;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) wrenches[b].torque += torque[b].total();
}

void CableSystem::Impl::compute_forces(double dt) {
  update_ropes();
  compute_element_forces();
  clear_applied();
  add_hinges();
  if (!ropes.empty()) {
    ropes.add_flow_forces(coordinates, velocities, applied);
    loaded_slots.insert(loaded_slots.end(), ropes.massive_slots().begin(), ropes.massive_slots().end());
  }
  contacts.add_forces(
      coordinates, velocities, inverse_mass, element_length, bodies, dt,
      [this](std::int32_t slot) { return slot_force(slot); }, applied, wrenches);
  loaded_slots.insert(loaded_slots.end(), contacts.touched_slots().begin(), contacts.touched_slots().end());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    SectorSum<Eigen::Vector3d> force(Eigen::Vector3d::Zero()), torque(Eigen::Vector3d::Zero());
    for (const DynamicBody::Attachment& attachment : bodies[b].attachments()) {
      const Wrench wrench = bodies[b].attachment_wrench(attachment, slot_force(attachment.slot));
      force.add(attachment.slot, wrench.force);
      torque.add(attachment.slot, wrench.torque);
    }
    wrenches[b] += Wrench{force.total(), torque.total()};
    wrenches[b].force += model.bodies[b].mass * model.gravity;
    wrenches[b].torque +=
        (bodies[b].centre() - bodies[b].rigid().position()).cross(model.bodies[b].mass * model.gravity);
  }
}

// What an element touched in the last step, for messages.
std::string CableSystem::Impl::contact_of(std::int32_t element) const {
  for (const ContactPoint& contact : contacts.contacts()) {
    if (contact.element == element) return fmt::format(", in contact with the {},", model.bodies[contact.body].name);
  }
  return ", without contact,";
}

Eigen::MatrixX3d CableSystem::Impl::all_slot_forces() const {
  Eigen::MatrixX3d force(layout.size(), 3);
  for (std::int32_t slot = 0; slot < layout.size(); ++slot) force.row(slot) = slot_force(slot).transpose();
  return force;
}

void CableSystem::Impl::move_slots(double kick, double drift) {
  if (consistent_mass) {
    const Eigen::MatrixX3d acceleration = consistent_mass->solve(all_slot_forces(), mass);
    for (std::int32_t slot = 0; slot < layout.size(); ++slot) {
      if (inverse_mass[slot] == 0) continue;
      velocities.add(slot, kick * acceleration.row(slot).transpose());
      coordinates.add(slot, drift * velocities.get(slot));
    }
    return;
  }
  static const slot_kernel::Kernel kernel = choose_slot_kernel();
  slot_kernel::UpdateView view{};
  assembly.describe(view);
  view.element_forces = element_forces.data();
  view.inverse_mass = inverse_mass.data();
  view.applied = applied.arrays();
  view.coordinates = coordinates.arrays();
  view.velocities = velocities.arrays();
  for_chunks(assembly.block_count(), [&](int, int first, int last) { kernel(view, first, last, kick, drift); });
}

void CableSystem::Impl::step(double dt) {
  compute_forces(dt);
  // Velocities stand half a step of the previous size before the positions; at the start they stand with them.
  const double kick = 0.5 * (last_dt + dt);
  const double power_before = contacts.dissipated_power(velocities, bodies);
  if (!ropes.empty()) input_work += kick * ropes.feeding_power(coordinates, velocities);
  dissipated += kick * (damping_power + hinge_power);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    impulses[b] += kick * contacts.force_on(static_cast<std::int32_t>(b));
  }
  deepest_penetration = std::max(deepest_penetration, contacts.deepest_penetration());

  move_slots(kick, dt);
  for (std::size_t b = 0; b < bodies.size(); ++b) input_work += bodies[b].step(wrenches[b], controls[b], kick, dt);
  dissipated += 0.5 * kick * (power_before + contacts.dissipated_power(velocities, bodies));
  for (DynamicBody& body : bodies) body.move_attachments(coordinates, velocities);
  time += dt;
  last_dt = dt;
  ++steps;
}

ElementCoordinates CableSystem::Impl::gather(const SlotVectors& vectors, std::size_t element) const {
  ElementCoordinates q;
  for (int corner = 0; corner < 4; ++corner) q.col(corner) = vectors.get(elements[element].slot[corner]);
  return q;
}

MaterialSpan CableSystem::Impl::span(std::size_t element) const {
  const MaterialSpan* variable = ropes.span_of(static_cast<std::int32_t>(element));
  return variable != nullptr ? *variable : MaterialSpan{.length = elements[element].length};
}

double CableSystem::Impl::strain_energy() const {
  double energy = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ElementCoordinates q = gather(coordinates, i);
    if (options.evaluation == ElementEvaluation::full) {
      const FullElement element(elements[i].section, span(i));
      energy += element.axial_energy(q) + element.bending_energy(q);
    } else {
      const MeanStrainElement element(elements[i].section, span(i));
      energy += element.axial_energy(q) + element.bending_energy(q);
    }
  }
  for (const Hinge& hinge : model.hinges) {
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    energy += hinge_forces(hinge, coordinates.get(layout.gradient(hinge.gradient1)),
                           coordinates.get(layout.gradient(hinge.gradient2)), zero, zero,
                           hinge.body >= 0 ? bodies[hinge.body].rigid().rotation() : Eigen::Matrix3d::Identity(), zero)
                  .energy;
  }
  return energy;
}

// Of the velocities half a step on, where positions are.
double CableSystem::Impl::kinetic_energy() const {
  const double half_kick = 0.5 * last_dt;
  double energy = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    energy += bodies[b].kinetic_energy_after(wrenches[b], controls[b], half_kick);
  }
  if (consistent_mass) {
    Eigen::MatrixX3d velocity = consistent_mass->solve(all_slot_forces(), mass) * half_kick;
    for (std::int32_t slot = 0; slot < layout.size(); ++slot) velocity.row(slot) += velocities.get(slot).transpose();
    return energy + consistent_mass->kinetic_energy(velocity, mass);
  }
  for (std::int32_t slot = 0; slot < layout.size(); ++slot) {
    if (inverse_mass[slot] == 0) continue;
    const Eigen::Vector3d velocity = velocities.get(slot) + half_kick * inverse_mass[slot] * slot_force(slot);
    energy += 0.5 * mass[slot] * velocity.squaredNorm();
  }
  return energy;
}

// Work of gravity and constant loads up to an additive constant.
double CableSystem::Impl::load_work() const {
  double work = 0;
  for (std::int32_t slot = 0; slot < layout.size(); ++slot) work += constant_load.get(slot).dot(coordinates.get(slot));
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    work += model.bodies[b].mass * model.gravity.dot(bodies[b].centre());
  }
  return work;
}

EnergyAudit CableSystem::Impl::audit() {
  const double half_kick = 0.5 * last_dt;
  EnergyAudit result;
  result.kinetic = kinetic_energy();
  result.strain = strain_energy();
  result.dissipated =
      dissipated + half_kick * (damping_power + hinge_power + contacts.dissipated_power(velocities, bodies));
  result.input = input_work + load_work() - initial_load_work;
  if (!ropes.empty()) result.input += half_kick * ropes.feeding_power(coordinates, velocities);
  result.error = result.kinetic + result.strain + result.dissipated - result.input - initial_energy;
  return result;
}

CableSystem::CableSystem(const Model& model, const SystemOptions& options)
    : impl_(std::make_unique<Impl>(model, options)) {}
CableSystem::~CableSystem() = default;
CableSystem::CableSystem(CableSystem&&) noexcept = default;
CableSystem& CableSystem::operator=(CableSystem&&) noexcept = default;

const Model& CableSystem::model() const { return impl_->model; }
double CableSystem::time() const { return impl_->time; }
std::int64_t CableSystem::steps() const { return impl_->steps; }
void CableSystem::step(double dt) { impl_->step(dt); }

StableStep CableSystem::stable_step() const {
  std::vector<BatchElement> now = impl_->elements;
  for (std::size_t i = 0; i < now.size(); ++i) now[i].length = impl_->element_length[i];
  if (impl_->consistent_mass) return find_stable_step_of_full_elements(impl_->model, now, impl_->coordinates);
  return find_stable_step(impl_->model, impl_->layout, now, impl_->inverse_mass, impl_->coordinates);
}

std::optional<std::string> CableSystem::fault() const {
  const Impl& s = *impl_;
  for (std::size_t i = 0; i < s.elements.size(); ++i) {
    for (int corner = 0; corner < 4; ++corner) {
      const std::int32_t slot = s.elements[i].slot[corner];
      const double speed = s.velocities.get(slot).norm() * (corner % 2 == 0 ? 1.0 : s.element_length[i]);
      if (speed < kRunawaySpeed && s.coordinates.get(slot).allFinite()) continue;
      return fmt::format("{} (element {}){} moves at {:.3g} m/s", s.model.threads[s.model.elements[i].thread], i,
                         s.contact_of(static_cast<std::int32_t>(i)), speed);
    }
  }
  for (std::size_t b = 0; b < s.bodies.size(); ++b) {
    const RigidBody& body = s.bodies[b].rigid();
    if (body.position().allFinite() && body.velocity().norm() < kRunawaySpeed && body.angular_momentum().allFinite())
      continue;
    return fmt::format("the {} moves at {:.3g} m/s", s.model.bodies[b].name, body.velocity().norm());
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
const RopeMotion& CableSystem::rope_motion(std::int32_t rope) const { return impl_->ropes.motion(rope); }

void CableSystem::displace(std::int32_t node, const Eigen::Vector3d& displacement) {
  impl_->coordinates.add(impl_->layout.position(node), displacement);
}
void CableSystem::control(std::int32_t body, const BodyControl& control) { impl_->controls[body] = control; }
void CableSystem::set_rope_motion(const std::function<RopeMotion(double)>& motion) { impl_->ropes.set_motion(motion); }
void CableSystem::set_friction(double coefficient) { impl_->contacts.set_friction(coefficient); }

const Eigen::Vector3d& CableSystem::contact_impulse(std::int32_t body) const { return impl_->impulses[body]; }
double CableSystem::take_deepest_penetration() { return std::exchange(impl_->deepest_penetration, 0.0); }

void CableSystem::visit_state(const std::function<void(double&)>& visit) {
  Impl& s = *impl_;
  // Nothing is touched unless the visitor changes it: to look at the state must not change a bit of the run.
  const auto visit_number = [&](double& number) {
    const double before = number;
    visit(number);
    return number != before;
  };
  const auto visit_vector = [&](auto&& v) {
    bool changes = false;
    for (Eigen::Index i = 0; i < v.size(); ++i) changes = visit_number(v[i]) || changes;
    return changes;
  };
  bool changed = false;
  for (SlotVectors* vectors : {&s.coordinates, &s.velocities}) {
    for (std::int32_t slot = 0; slot < s.layout.size(); ++slot) {
      Eigen::Vector3d value = vectors->get(slot);
      if (!visit_vector(value)) continue;
      vectors->set(slot, value);
      changed = true;
    }
  }
  for (DynamicBody& body : s.bodies) {
    RigidBodyState state = body.rigid().state();
    bool moved = visit_vector(state.position);
    moved = visit_vector(state.velocity) || moved;
    moved = visit_vector(state.attitude.coeffs()) || moved;
    moved = visit_vector(state.angular_momentum) || moved;
    if (moved) body.rigid().restore(state);
    changed = changed || moved;
  }
  for (Eigen::Vector3d& impulse : s.impulses) visit_vector(impulse);
  double steps = static_cast<double>(s.steps);
  for (double* value : {&s.time, &s.last_dt, &steps, &s.input_work, &s.dissipated, &s.initial_energy,
                        &s.initial_load_work, &s.deepest_penetration}) {
    visit(*value);
  }
  // A file may hold what is no count.
  if (steps >= 0 && steps < 9e15) s.steps = static_cast<std::int64_t>(steps);
  if (changed) s.contacts.forget_candidates();
}

EnergyAudit CableSystem::audit() {
  impl_->compute_forces(impl_->last_dt > 0 ? impl_->last_dt : 1e-4);
  return impl_->audit();
}

EnergyAudit CableSystem::capture(Snapshot& snapshot) {
  Impl& s = *impl_;
  s.compute_forces(s.last_dt > 0 ? s.last_dt : 1e-4);
  snapshot.time = s.time;
  snapshot.step = s.steps;
  snapshot.positions.resize(3, s.layout.node_count);
  snapshot.velocities.resize(3, s.layout.node_count);
  snapshot.gradients.resize(3, s.layout.gradient_count);
  for (std::int32_t i = 0; i < s.layout.node_count; ++i) {
    snapshot.positions.col(i) = position(i);
    snapshot.velocities.col(i) = velocity(i);
  }
  for (std::int32_t i = 0; i < s.layout.gradient_count; ++i) snapshot.gradients.col(i) = gradient(i);
  snapshot.tension.resize(static_cast<Eigen::Index>(s.elements.size()));
  snapshot.strain.resize(static_cast<Eigen::Index>(s.elements.size()));
  for (std::size_t i = 0; i < s.elements.size(); ++i) {
    const MeanStrainElement element(s.elements[i].section, s.span(i));
    const ElementCoordinates q = s.gather(s.coordinates, i);
    snapshot.tension[static_cast<Eigen::Index>(i)] = element.tension(q, s.gather(s.velocities, i));
    snapshot.strain[static_cast<Eigen::Index>(i)] = element.strain(q);
  }
  snapshot.rope_element_length.clear();
  for (std::int32_t rope = 0; rope < s.ropes.rope_count(); ++rope) {
    snapshot.rope_element_length.push_back(s.ropes.element_length(rope));
  }
  snapshot.bodies.clear();
  for (const DynamicBody& body : s.bodies) snapshot.bodies.push_back(body.state());
  snapshot.contacts = s.contacts.contacts();
  return s.audit();
}

}  // namespace netpocket
