#include <algorithm>
#include <numeric>

#include "engine/ancf/full_element.h"
#include "engine/ancf/strain_pair.h"
#include "engine/dynamics/joints/hinge_forces.h"
#include "engine/dynamics/system/cable_system_impl.h"

namespace netpocket {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

void CableSystem::Impl::compute_states() {
  element_states.resize(static_cast<std::size_t>(batch.block_count()) * kStateRows * kBlockSize);
  loop()(batch.block_count(), kElementRange / kBlockSize, [&](int first, int last) {
    batch.states(first, last, coordinates.rows(), velocities.rows(), element_states.data());
  });
}

// A row of the last compute_states, by lane.
const double* CableSystem::Impl::state_row(int block, std::size_t row) const {
  return element_states.data() + (static_cast<std::size_t>(block) * kStateRows + row) * kBlockSize;
}

double CableSystem::Impl::element_state(std::size_t element, std::size_t row) const {
  return state_row(static_cast<int>(element / kBlockSize), row)[element % kBlockSize];
}

// The value of a row that determines an element's tension: its own, or the paired one with its strain partner.
double CableSystem::Impl::resisted(std::size_t element, std::size_t row) const {
  const std::int32_t strain_partner =
      options.evaluation == ElementEvaluation::full ? -1 : model.elements[element].strain_partner;
  const double own = element_state(element, row);
  return strain_partner < 0 ? own : paired_strain(own, element_state(static_cast<std::size_t>(strain_partner), row));
}

double CableSystem::Impl::tension(std::size_t element) const {
  if (options.evaluation == ElementEvaluation::full) return full_stretching(element).tension;
  const CableSection& section = model.material_of(static_cast<std::int32_t>(element)).section;
  const double strain = resisted(element, kStrain);
  return section.axial_stiffness(strain) * (strain + section.axial_damping * resisted(element, kStrainRate));
}

double CableSystem::Impl::strain(std::size_t element) const {
  if (options.evaluation == ElementEvaluation::full) return full_stretching(element).strain;
  return element_state(element, kStrain);
}

double CableSystem::Impl::strain_energy_of(std::size_t first, std::size_t last) const {
  double energy = 0;
  for (std::size_t i = first; i < last; ++i) {
    const CableSection& section = model.material_of(static_cast<std::int32_t>(i)).section;
    if (options.evaluation == ElementEvaluation::full) {
      const ElementCoordinates q = gather(coordinates, i);
      const FullElement element(section, span(i));
      energy += element.axial_energy(q) + element.bending_energy(q);
    } else {
      const double strain = resisted(i, kStrain);
      const double stiffness = section.axial_stiffness(strain) * element_length[i];
      energy += 0.5 * stiffness * strain * element_state(i, kStrain) + element_state(i, kBendingEnergy);
    }
  }
  return energy;
}

double CableSystem::Impl::strain_energy() {
  double energy = wrinkling.energy(coordinates);
  energy += sum(values_of_ranges<double>(loop(), static_cast<int>(model.elements.size()), kElementRange,
                                         [&](int first, int last) { return strain_energy_of(first, last); }));
  for (const Hinge& hinge : model.hinges) {
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    energy += hinge_forces(hinge, coordinates.get(layout.gradient(hinge.gradient1)),
                           coordinates.get(layout.gradient(hinge.gradient2)), zero, zero,
                           hinge.body >= 0 ? bodies[hinge.body].rigid().rotation() : Eigen::Matrix3d::Identity(), zero)
                  .energy;
  }
  return energy;
}

// Velocities after a kick (s) with the present forces. Half of the last step brings them to the time of the positions.
CoordinateVectors CableSystem::Impl::velocities_after(double kick) {
  CoordinateVectors velocity = velocities;
  move_coordinates(velocity, unmoved, kick, 0);
  return velocity;
}

// Kinetic energy (J) of free coordinates, without attachments. `squares`(first, count): squared speeds of `count`
// coordinates from `first` on.
template <typename Squares>
double CableSystem::Impl::lumped_energy(const Squares& squares) {
  return sum(values_of_ranges<double>(loop(), layout.size(), kCoordinateRange, [&](int first, int last) {
    const Eigen::Map<const Eigen::Array<double, kBlockSize, Eigen::Dynamic>> mass_of_blocks(
        moving_mass.data() + first, kBlockSize, (last - first) / kBlockSize);
    return 0.5 * (mass_of_blocks * squares(first, last - first)).sum();
  }));
}

// Kinetic energy (J) of bodies at the end of their half kick, and of nodes and gradients with their lumped or
// consistent mass at the given velocities.
double CableSystem::Impl::kinetic_energy(const CoordinateVectors& velocity) {
  double energy = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    energy += bodies[b].kinetic_energy_after(wrenches[b], controls[b], 0.5 * last_dt);
  }
  if (consistent_mass) return energy + consistent_mass->kinetic_energy(velocity, mass);
  return energy + lumped_energy([&](int first, int count) { return velocity.squared_norms(first, count); });
}

// Velocities half a step apart differ by the waves that the step does not resolve. The energy of the difference is the
// aliased energy.
double CableSystem::Impl::aliased_energy(const CoordinateVectors& velocity) {
  return lumped_energy([&](int first, int count) { return velocity.squared_distances(velocities, first, count); });
}

// Work of gravity and constant loads, up to an additive constant.
double CableSystem::Impl::load_work() const {
  double work = 0;
  const CoordinateVectors* loads = applied.constant();
  for (std::int32_t coordinate = 0; loads != nullptr && coordinate < layout.size(); ++coordinate) {
    work += loads->get(coordinate).dot(coordinates.get(coordinate));
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    work += model.bodies[b].mass * model.gravity.dot(bodies[b].centre());
  }
  return work;
}

// Power at the velocities that the present forces lead to.
contact_kernel::ContactPower CableSystem::Impl::contact_power_after(double kick) {
  CoordinateVectors positions = coordinates, velocity = velocities_after(kick);
  std::vector<DynamicBody> moving = bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    moving[b].rigid() = bodies[b].after(wrenches[b], controls[b], kick);
    moving[b].move_attachments(positions, velocity);
  }
  return contact_power(contacts.dissipated_power(velocity, moving), velocity, moving);
}

EnergyAudit CableSystem::Impl::audit() {
  const double half_kick = 0.5 * last_dt;
  compute_states();
  step_of_states = steps;
  const CoordinateVectors velocity = velocities_after(half_kick);
  const RopeDynamics::FlowEnergy flow = ropes.flow_energy(coordinates, velocity);
  EnergyAudit result;
  result.kinetic = kinetic_energy(velocity) + flow.kinetic;
  result.aliased = aliased_energy(velocity);
  result.strain = strain_energy();
  const contact_kernel::ContactPower before = contact_power(contacts.dissipated_power_before(), velocities, bodies);
  const contact_kernel::ContactPower after = contact_power_after(last_dt);
  // Energy of the first half of the step that the forces act for, at most that of the whole step. Where a contact
  // rebounds within the step, its first half alone dissipates more than the whole.
  const auto first_half = [half_kick](double power, double later) {
    return std::clamp(half_kick * power, 0.0, std::max(half_kick * (power + later), 0.0));
  };
  result.contact = contacts.stored_energy();
  if (cord_contacts) result.contact += cord_contacts->stored_energy();
  if (body_contacts) result.contact += body_contacts->stored_energy();
  result.spent = spent;
  result.spent.in_cords += half_kick * element_power.dissipated;
  result.spent.at_hinges += half_kick * hinge_power;
  result.spent.in_contacts += first_half(before.damping, after.damping);
  result.spent.by_friction += first_half(before.friction, after.friction);
  result.input = input_work + half_kick * (element_power.fed + contacts.fed_power(coordinates, batch)) + load_work() +
                 flow.work - 0.5 * ropes.energy_change(coordinates, velocities) - initial_input;
  result.error = result.kinetic + result.strain + result.contact + result.spent.total() - result.input - initial_energy;
  last_audit = result;
  step_of_audit = steps;
  return result;
}

EnergyAudit CableSystem::audit() {
  Impl& s = *impl_;
  if (s.step_of_audit == s.steps && s.step_of_forces == s.steps) return s.last_audit;
  s.keep_forces_current(s.last_dt > 0 ? s.last_dt : 1e-4);
  return s.audit();
}

double CableSystem::aliased_energy(double dt) {
  Impl& s = *impl_;
  s.keep_forces_current(s.last_dt > 0 ? s.last_dt : 1e-4);
  return s.aliased_energy(s.velocities_after(0.5 * dt));
}

namespace {

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

EnergyAudit CableSystem::capture(Snapshot& snapshot) {
  Impl& s = *impl_;
  const EnergyAudit energies = audit();
  snapshot.time = s.time;
  snapshot.step = s.steps;
  copy_coordinates(s.coordinates, s.layout.position(0), s.layout.node_count, snapshot.positions);
  copy_coordinates(s.velocities, s.layout.position(0), s.layout.node_count, snapshot.velocities);
  copy_coordinates(s.coordinates, s.layout.gradient(0), s.layout.gradient_count, snapshot.gradients);
  snapshot.tension.resize(static_cast<Eigen::Index>(s.model.elements.size()));
  snapshot.strain.resize(static_cast<Eigen::Index>(s.model.elements.size()));
  for (std::size_t i = 0; i < s.model.elements.size(); ++i) {
    snapshot.tension[static_cast<Eigen::Index>(i)] = s.tension(i);
    snapshot.strain[static_cast<Eigen::Index>(i)] = s.strain(i);
  }
  snapshot.rope_element_length.clear();
  for (std::int32_t rope = 0; rope < s.ropes.rope_count(); ++rope) {
    snapshot.rope_element_length.push_back(s.ropes.element_length(rope));
  }
  snapshot.bodies.clear();
  for (const DynamicBody& body : s.bodies) snapshot.bodies.push_back(body.state());
  snapshot.contacts = s.contacts.contacts();
  if (s.body_contacts) s.body_contacts->append_points(snapshot.contacts);
  return energies;
}

}  // namespace netpocket
