#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/ancf/full_batch.h"
#include "engine/ancf/instruction_set.h"
#include "engine/bodies/sector_sum.h"
#include "engine/dynamics/cable_system_impl.h"
#include "engine/dynamics/hinge_forces.h"

namespace netpocket {
namespace {

// Blocks that one task computes. Fixed, so that sums over tasks do not depend on the number of threads.
constexpr int kChunk = 128;
// Below this number of elements a second thread costs more than it gives.
constexpr std::size_t kFewestElementsForThreads = 20000;

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

}  // namespace

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
  const bool full = options.evaluation == ElementEvaluation::full;
  chunk_power.resize((batch.block_count() + kChunk - 1) / kChunk);
  for_chunks(batch.block_count(), [&](int chunk, int first, int last) {
    const SlotArrays q = coordinates.arrays(), velocity = velocities.arrays();
    chunk_power[chunk] = full ? full_batch.forces(batch, first, last, q, velocity, element_forces.data())
                              : batch.forces(first, last, q, velocity, element_forces.data());
  });
  element_power = {};
  for (const BatchPower& power : chunk_power) {
    element_power.dissipated += power.dissipated;
    element_power.fed += power.fed;
  }
}

void CableSystem::Impl::clear_applied() {
  for (const std::int32_t slot : loaded_slots) {
    applied.set(slot, constant_load.get(slot));
    loaded[slot / kBlockSize] = loaded_at_rest[slot / kBlockSize];
  }
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

// All contacts see the same state: they are found before any of them acts.
void CableSystem::Impl::add_contacts(double dt) {
  contacted.clear();
  contacts.find(coordinates, velocities, element_length, bodies, dt, contacted);
  if (cord_contacts) cord_contacts->find(coordinates, velocities, element_length, dt, contacted);
  contacted.predict(velocities, inverse_mass, dt, [this](std::int32_t slot) { return slot_force(slot); });
  contacts.add_forces(velocities, contacted, inverse_mass, bodies, dt, applied, wrenches);
  if (cord_contacts) cord_contacts->add_forces(velocities, contacted, inverse_mass, dt, applied);
  loaded_slots.insert(loaded_slots.end(), contacted.slots().begin(), contacted.slots().end());
}

// Power that all contacts take out of the motion now, W.
double CableSystem::Impl::contact_power() const {
  const double power = contacts.dissipated_power(velocities, bodies);
  return cord_contacts ? power + cord_contacts->dissipated_power(velocities) : power;
}

// A snapshot leaves the forces of the state behind: the next step need not compute them again.
void CableSystem::Impl::keep_forces_current(double dt) {
  if (step_of_forces == steps && step_size_of_forces == dt) return;
  compute_forces(dt);
  step_of_forces = steps;
  step_size_of_forces = dt;
}

void CableSystem::Impl::compute_forces(double dt) {
  update_ropes();
  compute_element_forces();
  clear_applied();
  add_hinges();
  wrinkling.add_forces(coordinates, applied, loaded_slots);
  if (!ropes.empty()) {
    ropes.add_flow_forces(coordinates, velocities, last_dt, 0.5 * (last_dt + dt), applied);
    loaded_slots.insert(loaded_slots.end(), ropes.massive_slots().begin(), ropes.massive_slots().end());
  }
  add_contacts(dt);
  for (const std::int32_t slot : loaded_slots) loaded[slot / kBlockSize] = 1;
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

// v += kick M^-1 F, x += drift v with a diagonal mass.
void CableSystem::Impl::kick_and_drift(SlotVectors& v, SlotVectors& x, const AlignedVector<double>& inverse_masses,
                                       double kick, double drift) {
  static const slot_kernel::Kernel kernel = choose_slot_kernel();
  slot_kernel::UpdateView view{};
  assembly.describe(view);
  view.element_forces = element_forces.data();
  view.inverse_mass = inverse_masses.data();
  view.applied = applied.arrays();
  view.loaded = loaded.data();
  view.coordinates = x.arrays();
  view.velocities = v.arrays();
  for_chunks(assembly.block_count(), [&](int, int first, int last) { kernel(view, first, last, kick, drift); });
}

// The same with the evaluation's mass. With the consistent one the forces are first collected: they are what a kick
// with unit masses adds to velocities that were zero.
void CableSystem::Impl::move_slots(SlotVectors& v, SlotVectors& x, double kick, double drift) {
  if (!consistent_mass) {
    kick_and_drift(v, x, inverse_mass, kick, drift);
    return;
  }
  forces.set_zero();
  kick_and_drift(forces, unmoved, unit_mass, 1, 0);
  consistent_mass->kick_and_drift(forces, mass, kick, drift, v, x);
}

void CableSystem::Impl::step(double dt) {
  keep_forces_current(dt);
  // Velocities stand half a step of the previous size before the positions; at the start they stand with them.
  const double kick = 0.5 * (last_dt + dt);
  const double power_before =
      contacts.dissipated_power() + (cord_contacts ? cord_contacts->dissipated_power(velocities) : 0);
  input_work += kick * element_power.fed;
  dissipated += kick * (element_power.dissipated + hinge_power);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    impulses[b] += kick * contacts.force_on(static_cast<std::int32_t>(b));
  }
  deepest_penetration = std::max(deepest_penetration, contacts.deepest_penetration());
  double ropes_change = ropes.energy_change(coordinates, velocities);

  move_slots(velocities, coordinates, kick, dt);
  ropes_change += ropes.energy_change(coordinates, velocities);
  input_work -= 0.5 * ropes_change;
  ropes.finish_step();
  for (std::size_t b = 0; b < bodies.size(); ++b) input_work += bodies[b].step(wrenches[b], controls[b], kick, dt);
  dissipated += 0.5 * kick * (power_before + contact_power());
  for (DynamicBody& body : bodies) body.move_attachments(coordinates, velocities);
  time += dt;
  last_dt = dt;
  ++steps;
}

}  // namespace netpocket
