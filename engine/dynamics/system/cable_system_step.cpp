#include <fmt/format.h>

#include <algorithm>

#include "engine/ancf/full_batch.h"
#include "engine/dynamics/system/cable_system_impl.h"
#include "engine/math/instruction_set.h"
#include "engine/math/sector_sum.h"

namespace netpocket {
namespace {

// Number of blocks that a thread processes at once and whose powers it sums in sequence. Constant, so that sums do not
// depend on the number of threads.
constexpr int kChunk = 32;

struct StepKernels {
  update_kernel::Kernel update;
  update_kernel::SumKernel sum_forces;
  hinge_kernel::Kernel hinges;
};

const StepKernels& step_kernels() {
  static const StepKernels chosen = {NETPOCKET_VARIANT_OF(update_kernel, update),
                                     NETPOCKET_VARIANT_OF(update_kernel, sum_forces),
                                     NETPOCKET_VARIANT_OF(hinge_kernel, forces)};
  return chosen;
}

// The larger of two non-negative numbers; NaN if either is NaN.
double larger_or_none(double a, double b) { return a >= b || a != a ? a : b; }

}  // namespace

DividedLoop CableSystem::Impl::loop() {
  if (!team) return undivided_loop;
  return [this](int count, int grain, const auto& work) { team->run(count, grain, work); };
}

template <typename Meanwhile>
void CableSystem::Impl::compute_element_forces(const Meanwhile& meanwhile) {
  const bool full = options.evaluation == ElementEvaluation::full;
  const int chunks = (batch.block_count() + kChunk - 1) / kChunk;
  chunk_power.resize(chunks);
  const auto compute = [&](int first_chunk, int last_chunk) {
    const CoordinateRows q = coordinates.rows(), velocity = velocities.rows();
    for (int chunk = first_chunk; chunk < last_chunk; ++chunk) {
      const int first = chunk * kChunk, last = std::min(batch.block_count(), first + kChunk);
      chunk_power[chunk] = full ? full_batch.forces(batch, first, last, q, velocity, element_forces.data())
                                : batch.forces(first, last, q, velocity, element_forces.data());
    }
  };
  if (team) {
    team->run(chunks, 1, compute, meanwhile);
  } else {
    meanwhile();
    compute(0, chunks);
  }
  element_power = {};
  for (const BatchPower& power : chunk_power) {
    element_power.dissipated += power.dissipated;
    element_power.fed += power.fed;
  }
}

void CableSystem::Impl::add_hinges(double kick) {
  hinge_power = 0;
  hinge_safeguards = {};
  hinge_torques.assign(bodies.size(), SectorSum<Eigen::Vector3d>(Eigen::Vector3d::Zero()));
  for (HingeBlock& block : hinges) {
    hinge_kernel::Axes axes{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    if (block.body >= 0) {
      const RigidBody& body = bodies[block.body].rigid();
      std::copy_n(body.rotation().data(), 9, axes.rotation);
      std::copy_n(body.angular_velocity().data(), 3, axes.angular_velocity);
    }
    step_kernels().hinges(coordinates.rows(), velocities.rows(), inverse_mass.data(), kick, axes, block);
    for (int lane = 0; lane < block.count; ++lane) {
      applied.add(block.gradient1[lane], lane_of(block.on_gradient1, lane));
      applied.add(block.gradient2[lane], lane_of(block.on_gradient2, lane));
      if (block.body >= 0) hinge_torques[block.body].add(lane, lane_of(block.torque_on_body, lane));
      hinge_power += block.dissipated_power[lane];
      hinge_safeguards.limited_hinges += block.is_limited[lane] > 0 ? 1 : 0;
      hinge_safeguards.loose_hinges += block.is_loose[lane] > 0 ? 1 : 0;
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) wrenches[b].torque += hinge_torques[b].total();
}

// All contacts are found before any of them exerts a force, so that all see the same state.
void CableSystem::Impl::find_contacts(double dt) {
  contacted.clear();
  contacts.find(coordinates, velocities, batch, bodies, cord_speed, dt, contacted);
  if (cord_contacts) cord_contacts->find(coordinates, velocities, element_length, dt, contacted);
}

void CableSystem::Impl::add_contacts(const StepTimes& times) {
  contacted.predict(velocities, inverse_mass, times.kick,
                    [this](auto blocks, double* rows) { sum_forces(blocks, rows); });
  contacts.add_forces(velocities, contacted, inverse_mass, bodies, times, applied, wrenches);
  if (cord_contacts) cord_contacts->add_forces(velocities, contacted, inverse_mass, times, applied);
}

// Power that all contacts dissipate at the velocities `at`. `on_bodies`: the part of contacts between cords and bodies.
contact_kernel::ContactPower CableSystem::Impl::contact_power(contact_kernel::ContactPower on_bodies,
                                                              const CoordinateVectors& at,
                                                              const std::vector<DynamicBody>& moving) const {
  contact_kernel::ContactPower power = on_bodies;
  if (cord_contacts) power += cord_contacts->dissipated_power(at);
  if (body_contacts) {
    const BodyContact::Power of_bodies = body_contacts->power(moving);
    power += contact_kernel::ContactPower{of_bodies.damping, of_bodies.friction};
  }
  return power;
}

void CableSystem::Impl::find_cord_speed() {
  if (step_of_speed == steps) return;
  cord_speed = motion.speed(velocities, loop());
  step_of_speed = steps;
}

// The same bound as find_cord_speed, from values that the last update has found. Attached points follow from the
// bodies.
void CableSystem::Impl::note_cord_speed() {
  cord_speed = moved_speed;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].attachments().empty()) continue;
    const RigidBody& body = bodies[b].rigid();
    cord_speed =
        larger_or_none(cord_speed, body.velocity().norm() + body.angular_velocity().norm() * attachments_reach[b]);
  }
  step_of_speed = steps;
}

// Passes the motion since the last search to the searches. If an element's length changes by d, its curve moves by
// another |d| |S_2 + S_4|/L <= |d|/4 at most.
void CableSystem::Impl::note_motion() {
  double shortened = 0;
  noted_rope_length.resize(static_cast<std::size_t>(ropes.rope_count()), 0.0);
  for (std::int32_t rope = 0; rope < ropes.rope_count(); ++rope) {
    double& noted = noted_rope_length[static_cast<std::size_t>(rope)];
    shortened = std::max(shortened, std::abs(ropes.element_length(rope) - noted));
    noted = ropes.element_length(rope);
  }
  constexpr double kRounding = 1 + 1e-9;
  const double way = kRounding * (cords_way + 0.25 * shortened);
  for (double& body : bodies_way) body *= kRounding;
  contacts.note_motion(way, bodies_way);
  if (cord_contacts) cord_contacts->note_way(way);
  cords_way = 0;
  std::ranges::fill(bodies_way, 0.0);
}

// To be called after all other forces are known: contact between bodies depends on the motion that they lead to.
void CableSystem::Impl::touch_bodies(const StepTimes& times) {
  if (!body_contacts) return;
  body_contacts->find(bodies);
  body_contacts->add_forces(bodies, controls, times, wrenches);
}

// Forces computed for a snapshot are kept, so that the next step need not compute them again.
void CableSystem::Impl::keep_forces_current(double dt) {
  if (step_of_forces == steps && step_size_of_forces == dt) return;
  compute_forces(dt);
  step_of_forces = steps;
  step_size_of_forces = dt;
}

void CableSystem::Impl::compute_forces(double dt) {
  const StepTimes times{.kick = 0.5 * (last_dt + dt), .drift = dt};
  update_ropes();
  find_cord_speed();
  note_motion();
  if (cord_contacts) cord_contacts->look_around(coordinates, element_length, cord_speed, dt, loop());
  compute_element_forces([&] {
    applied.clear();
    for (Wrench& wrench : wrenches) wrench = Wrench{};
    add_hinges(times.kick);
    wrinkling.add_forces(coordinates, applied);
    if (!ropes.empty()) {
      ropes.add_flow_forces(coordinates, velocities, last_dt, times.kick, applied);
    }
    find_contacts(dt);
  });
  add_contacts(times);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    add_attachment_forces(b);
    wrenches[b].force += model.bodies[b].mass * model.gravity;
    wrenches[b].torque +=
        (bodies[b].centre() - bodies[b].rigid().position()).cross(model.bodies[b].mass * model.gravity);
  }
  touch_bodies(times);
}

// Adds the forces on a body's attachments, from elements and applied forces, to the body's wrench.
void CableSystem::Impl::add_attachment_forces(std::size_t body) {
  const std::span<const std::int32_t> blocks = attached_blocks[body];
  attached_forces.resize(blocks.size() * kVectorRows * kBlockSize);
  sum_forces(blocks, attached_forces.data());
  SectorSum<Eigen::Vector3d> force(Eigen::Vector3d::Zero()), torque(Eigen::Vector3d::Zero());
  std::size_t place = 0;
  for (const DynamicBody::Attachment& attachment : bodies[body].attachments()) {
    while (blocks[place] != attachment.coordinate / kBlockSize) ++place;
    const double* row = attached_forces.data() + place * kVectorRows * kBlockSize + attachment.coordinate % kBlockSize;
    const Wrench wrench = bodies[body].attachment_wrench(attachment, {row[0], row[kBlockSize], row[2 * kBlockSize]});
    force.add(attachment.coordinate, wrench.force);
    torque.add(attachment.coordinate, wrench.torque);
  }
  wrenches[body] += Wrench{force.total(), torque.total()};
}

// The body that an element touched in the last step, for messages.
std::string CableSystem::Impl::contact_of(std::int32_t element) const {
  for (const ContactPoint& contact : contacts.contacts()) {
    if (contact.element == element) return fmt::format(", in contact with the {},", model.bodies[contact.body].name);
  }
  return ", without contact,";
}

// Largest size (bytes) of the element forces for which the rest of a step's data also fits into a processor's own cache
// (1 to 2 MB).
constexpr std::size_t kCacheForForces = 1 << 19;

// Describes forces only: masses and state are not set.
update_kernel::UpdateView CableSystem::Impl::forces_view() {
  update_kernel::UpdateView view{};
  assembly.describe(view);
  view.element_forces = element_forces.data();
  view.exceeds_cache = element_forces.size() * sizeof(double) > kCacheForForces;
  view.applied = applied.rows();
  view.loaded = applied.loaded();
  return view;
}

void CableSystem::Impl::sum_forces(std::span<const std::int32_t> coordinate_blocks, double* rows) {
  step_kernels().sum_forces(forces_view(), coordinate_blocks.data(), coordinate_blocks.size(), rows);
}

// v += kick M^-1 F, x += drift v with a diagonal mass. Returns the largest resulting speeds, weighted and squared.
update_kernel::Fastest CableSystem::Impl::kick_and_drift(CoordinateVectors& v, CoordinateVectors& x,
                                                         const AlignedVector<double>& inverse_masses, double kick,
                                                         double drift) {
  update_kernel::UpdateView view = forces_view();
  view.inverse_mass = inverse_masses.data();
  view.coordinates = x.data();
  view.velocities = v.data();
  view.weight = motion.weights();
  view.gradient_block = layout.gradient(0) / kBlockSize;
  const auto update = [&](int first, int last) { return step_kernels().update(view, first, last, kick, drift); };
  if (!team) return update(0, assembly.block_count());
  update_kernel::Fastest fastest;
  for (const update_kernel::Fastest& part :
       values_of_ranges<update_kernel::Fastest>(loop(), assembly.block_count(), kChunk, update)) {
    fastest = {larger_or_none(fastest.position, part.position), larger_or_none(fastest.gradient, part.gradient)};
  }
  return fastest;
}

// Uses the mass matrix of the evaluation. For the consistent mass the forces are collected first: a kick with unit
// masses from zero velocity leaves the forces in `forces`.
void CableSystem::Impl::move_coordinates(CoordinateVectors& v, CoordinateVectors& x, double kick, double drift) {
  if (!consistent_mass) {
    const update_kernel::Fastest fastest = kick_and_drift(v, x, inverse_mass, kick, drift);
    moved_speed = MotionBound::speed(fastest.position, fastest.gradient);
    return;
  }
  forces.set_zero();
  kick_and_drift(forces, unmoved, unit_mass, 1, 0);
  consistent_mass->kick_and_drift(forces, mass, kick, drift, v, x);
}

// The stiffness of contacts is based on the first step.
void CableSystem::Impl::set_reference_step(double dt) {
  reference_step = dt;
  contacts.set_reference_step(dt);
  if (cord_contacts) cord_contacts->set_reference_step(dt);
  if (body_contacts && dt > 0) body_contacts->fix_stiffness(dt);
  forget_forces();
}

// Energy that springs of contacts lose as they become softer is spent.
void CableSystem::Impl::fit_contacts(double dt) {
  if (contacts.fits(dt)) return;
  keep_forces_current(dt);
  const double before = contacts.stored_energy();
  contacts.fit_stiffness(dt, bodies);
  forget_forces();
  keep_forces_current(dt);
  spent.in_contacts += std::max(before - contacts.stored_energy(), 0.0);
}

void CableSystem::Impl::step(double dt) {
  if (reference_step == 0) {
    set_reference_step(dt);
    begin_accounts();  // energy stored in springs at the start belongs to the initial energy
    forget_forces();
  }
  fit_contacts(dt);
  keep_forces_current(dt);
  // Velocities lag positions by half of the previous step. At the start there is no lag, since last_dt is 0.
  const double kick = 0.5 * (last_dt + dt);
  const contact_kernel::ContactPower before = contact_power(contacts.dissipated_power_before(), velocities, bodies);
  input_work += kick * (element_power.fed + contacts.fed_power(coordinates, batch));
  spent.in_cords += kick * element_power.dissipated;
  spent.at_hinges += kick * hinge_power;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    impulses[b] += kick * contacts.force_on(static_cast<std::int32_t>(b));
    if (body_contacts) body_impulses[b] += kick * body_contacts->force_on(static_cast<std::int32_t>(b));
  }
  note_contacts();
  double ropes_change = ropes.energy_change(coordinates, velocities);

  move_coordinates(velocities, coordinates, kick, dt);
  ropes_change += ropes.energy_change(coordinates, velocities);
  input_work -= 0.5 * ropes_change;
  ropes.finish_step(dt);
  for (std::size_t b = 0; b < bodies.size(); ++b) input_work += step_body(b, kick, dt);
  for (DynamicBody& body : bodies) body.move_attachments(coordinates, velocities);
  const contact_kernel::ContactPower after =
      contact_power(contacts.dissipated_power(velocities, bodies), velocities, bodies);
  // Neither is negative, apart from round-off.
  spent.in_contacts += std::max(0.5 * kick * (before.damping + after.damping), 0.0);
  spent.by_friction += std::max(0.5 * kick * (before.friction + after.friction), 0.0);
  time += dt;
  last_dt = dt;
  ++steps;
  if (consistent_mass) {
    find_cord_speed();
  } else {
    note_cord_speed();
  }
  cords_way += dt * cord_speed;  // of free coordinates; step_body adds that of attachments
}

// Records the contacts that the present step's forces are computed from.
void CableSystem::Impl::note_contacts() {
  safeguards += hinge_safeguards;
  safeguards.stopped_blows += contacts.stops();
  safeguards.unresolved_contacts += contacts.unresolved();
  depths.penetration = std::max(depths.penetration, contacts.deepest_penetration());
  depths.pressed.keep_deeper(contacts.deepest_part());
  if (!cord_contacts) return;
  safeguards.stopped_cords += cord_contacts->stops();
  safeguards.parted_overlaps += cord_contacts->partings();
  depths.overlapping.keep_deeper(cord_contacts->deepest_part());
}

// Returns the work (J) of the body's control. Between two poses, a point at distance a from the centre moves by at most
// the centre's displacement plus the chord of the rotation, 2 a sin(angle/2).
double CableSystem::Impl::step_body(std::size_t body, double kick, double dt) {
  DynamicBody& moving = bodies[body];
  const Eigen::Vector3d centre = moving.centre(), position = moving.rigid().position();
  const Eigen::Quaterniond attitude = moving.rigid().attitude();
  const double work = moving.step(wrenches[body], controls[body], kick, dt);
  const double chord = 2 * (attitude.conjugate() * moving.rigid().attitude()).vec().norm();
  bodies_way[body] += (moving.centre() - centre).norm() + chord * bounding_radius(model.bodies[body].shape);
  if (!moving.attachments().empty()) {
    cords_way += (moving.rigid().position() - position).norm() + chord * attachments_reach[body];
  }
  return work;
}

}  // namespace netpocket
