#pragma once
// The state of a CableSystem and what it does with it; shared by the sources of that class, internal to them:
//   cable_system.cpp         set-up, state, questions
//   cable_system_step.cpp    forces and the step
//   cable_system_energy.cpp  energies, audit, snapshots
//   cable_system_full.cpp    what the full evaluation asks its elements one by one

#include "engine/ancf/full_batch.h"
#include "engine/ancf/full_element.h"
#include "engine/base/thread_team.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/dynamics/assembly/assembly.h"
#include "engine/dynamics/assembly/consistent_mass.h"
#include "engine/dynamics/assembly/motion_bound.h"
#include "engine/dynamics/contact/body_contact.h"
#include "engine/dynamics/contact/contact_solver.h"
#include "engine/dynamics/contact/contacted_coordinates.h"
#include "engine/dynamics/contact/cord_contact.h"
#include "engine/dynamics/joints/hinge_kernel.h"
#include "engine/dynamics/joints/rod_wrinkling.h"
#include "engine/dynamics/ropes/rope_dynamics.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/math/sector_sum.h"

namespace netpocket {

// Elements and coordinates that a thread takes at once, and whose energies are summed in a row: fixed, so that sums do
// not depend on the number of threads. Whole blocks.
inline constexpr int kElementRange = 2048, kCoordinateRange = 8192;

// Rows of ElementBatch::states.
inline constexpr std::size_t kStrain = 0, kStrainRate = 1, kBendingEnergy = 2, kBendStiffness = 3;

struct CableSystem::Impl {
  Impl(Model&& model, const SystemOptions& options);

  // State at step n (positions) and n - 1/2 (velocities).
  Model model;
  SystemOptions options;
  std::unique_ptr<ThreadTeam> team;  // none: one thread steps
  CoordinateLayout layout;
  CoordinateVectors coordinates, velocities;
  double time = 0;
  double last_dt = 0;
  std::int64_t steps = 0;

  // Elements and masses.
  ElementBatch batch;
  FullBatch full_batch;
  Assembly assembly;
  std::vector<double> mass;  // by coordinate
  AlignedVector<double> inverse_mass;
  std::vector<double> element_length;
  std::vector<double> wave_speed;          // by material, sqrt(EA/m), m/s
  AlignedVector<double> wave_rate;         // by element, the square of wave speed by length, 1/s^2; whole blocks
  AlignedVector<double> moving_mass;       // by coordinate, of what moves by itself; else 0
  std::vector<double> mass_without_ropes;  // of the ropes' massive coordinates, in their order
  std::optional<ConsistentMass> consistent_mass;
  AlignedVector<double> unit_mass;
  CoordinateVectors forces;   // to collect them for the consistent mass
  CoordinateVectors unmoved;  // coordinates for kicks that move nothing

  // Parts.
  AlignedVector<HingeBlock> hinges;
  std::vector<DynamicBody> bodies;
  std::vector<BodyControl> controls;
  RopeDynamics ropes;
  RodWrinkling wrinkling;
  ContactSolver contacts;
  std::unique_ptr<CordContact> cord_contacts;  // none: cords pass through each other
  ContactedCoordinates contacted;
  MotionBound motion;
  // What has moved since contacts were looked for: bounds of the way of any point, m.
  double cords_way = 0;
  std::int64_t step_of_speed = -1;  // at which cord_speed has been found; -1: what it follows has changed since
  double cord_speed = 0;            // m/s, of any point at most
  double moved_speed = 0;           // the same, of what was last moved by its own mass
  std::vector<double> bodies_way;
  std::vector<double> attachments_reach;       // m, by body: farthest of what hangs on it
  std::vector<double> noted_rope_length;       // m, of an element, by rope, then
  std::unique_ptr<BodyContact> body_contacts;  // none: bodies pass through each other

  // Forces of the present state.
  AlignedVector<double> element_forces;
  AlignedVector<double> element_states;  // of the last audit
  std::int64_t step_of_states = -1;      // of the last audit; -1: the state has changed other than by steps
  AppliedForces applied;                 // all but element forces
  std::vector<Wrench> wrenches;          // by body
  std::vector<SectorSum<Eigen::Vector3d>> hinge_torques;  // by body
  std::vector<std::vector<std::int32_t>>
      attached_blocks;                    // by body: blocks of coordinates of its attachments, ascending
  AlignedVector<double> attached_forces;  // on these
  BatchPower element_power;
  double hinge_power = 0;
  SafeguardCounts hinge_safeguards;
  std::int64_t step_of_forces = -1;  // at which forces have been computed; -1: what they follow has changed since
  double step_size_of_forces = 0;    // s
  EnergyAudit last_audit;
  std::int64_t step_of_audit = -1;  // of the last one; -1: what it follows has changed since
  std::vector<BatchPower> chunk_power;

  // Accounts since the start.
  SpentEnergy spent;
  double input_work = 0, initial_energy = 0, initial_input = 0;
  double reference_step = 0;                   // s, that the stiffness of contacts is for; 0: no step yet
  std::vector<Eigen::Vector3d> impulses;       // of cords, by body
  std::vector<Eigen::Vector3d> body_impulses;  // of other bodies, by body
  SafeguardCounts safeguards;
  ContactDepths depths;

  std::vector<BatchElement> batch_elements() const;
  std::int32_t coordinate(std::size_t element, int corner) const {
    return batch.block(static_cast<int>(element / kBlockSize)).coordinate[corner][element % kBlockSize];
  }
  void set_initial_state();
  void begin_accounts();
  double reach_of_attachments(const DynamicBody& body) const;
  void state_has_jumped();
  void collect_mass();
  void collect_hinges();
  void update_ropes();
  void set_length(std::size_t element, double length);
  bool moves(std::int32_t coordinate) const;
  bool ends_at_strain_partner(const BatchElement& element) const;
  void set_constant_loads();
  // A loop that the team shares, if there is one.
  DividedLoop loop();
  // `meanwhile`: done by the caller's thread before it takes part.
  template <typename Meanwhile>
  void compute_element_forces(const Meanwhile& meanwhile);
  void add_hinges(double kick);
  void find_contacts(double dt);
  void add_contacts(const StepTimes& times);
  contact_kernel::ContactPower contact_power(contact_kernel::ContactPower on_bodies, const CoordinateVectors& at,
                                             const std::vector<DynamicBody>& moving) const;
  contact_kernel::ContactPower contact_power_after(double kick);
  void touch_bodies(const StepTimes& times);
  void find_cord_speed();
  void note_cord_speed();
  void note_motion();
  void set_reference_step(double dt);
  void note_contacts();
  void compute_forces(double dt);
  void keep_forces_current(double dt);
  void forget_forces() { step_of_forces = step_of_audit = -1; }
  update_kernel::Fastest kick_and_drift(CoordinateVectors& v, CoordinateVectors& x,
                                        const AlignedVector<double>& inverse_masses, double kick, double drift);
  void move_coordinates(CoordinateVectors& v, CoordinateVectors& x, double kick, double drift);
  void step(double dt);
  double step_body(std::size_t body, double kick, double dt);
  update_kernel::UpdateView forces_view();
  void sum_forces(std::span<const std::int32_t> coordinate_blocks, double* rows);
  void add_attachment_forces(std::size_t body);
  std::string contact_of(std::int32_t element) const;
  ElementCoordinates gather(const CoordinateVectors& vectors, std::size_t element) const;
  MaterialSpan span(std::size_t element) const;
  void compute_states();
  const double* state_row(int block, std::size_t row) const;
  double element_state(std::size_t element, std::size_t row) const;
  double resisted(std::size_t element, std::size_t row) const;
  double tension(std::size_t element) const;
  double strain(std::size_t element) const;
  FullElement::Stretching full_stretching(std::size_t element) const;
  double stable_step_as_stretched(const StableStep& straight);
  double strain_energy_of(std::size_t first, std::size_t last) const;  // of these elements
  double strain_energy();
  CoordinateVectors velocities_after(double kick);
  template <typename Squares>
  double lumped_energy(const Squares& squares);
  double kinetic_energy(const CoordinateVectors& velocity);
  double aliased_energy(const CoordinateVectors& velocity);
  double load_work() const;
  EnergyAudit audit();
  bool looks_sound();
};

}  // namespace netpocket
