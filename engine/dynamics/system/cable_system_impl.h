#pragma once
// State and internal operations of a CableSystem. Internal to the sources of that class:
//   cable_system.cpp         set-up, state, queries
//   cable_system_step.cpp    forces and the step
//   cable_system_energy.cpp  energies, audit, snapshots
//   cable_system_full.cpp    queries to single elements in the full evaluation

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

// Number of elements and coordinates that a thread processes at once and whose energies it sums in sequence. Constant
// and a multiple of the block size, so that sums do not depend on the number of threads.
inline constexpr int kElementRange = 2048, kCoordinateRange = 8192;

// Row numbers in the results of ElementBatch::states.
inline constexpr std::size_t kStrain = 0, kStrainRate = 1, kBendingEnergy = 2, kBendStiffness = 3;

struct CableSystem::Impl {
  Impl(Model&& model, const SystemOptions& options);

  // State: positions and gradients at step n, velocities at n - 1/2.
  Model model;
  SystemOptions options;
  std::unique_ptr<ThreadTeam> team;  // null: one thread
  CoordinateLayout layout;
  CoordinateVectors coordinates, velocities;
  double time = 0;
  double last_dt = 0;
  std::int64_t steps = 0;

  // Elements and masses.
  ElementBatch batch;
  FullBatch full_batch;
  Assembly assembly;
  std::vector<double> mass;  // lumped mass by coordinate
  AlignedVector<double> inverse_mass;
  std::vector<double> element_length;
  std::vector<double> wave_speed;          // m/s, by material: sqrt(EA/m)
  AlignedVector<double> wave_rate;         // 1/s^2, by element, in whole blocks: (wave speed/length)^2
  AlignedVector<double> unpaired_rate;     // the same; 0 for elements with a strain partner
  AlignedVector<double> moving_mass;       // by coordinate: mass of free coordinates; 0 for all others
  std::vector<double> mass_without_ropes;  // by entry of ropes.massive_coordinates(): mass of everything but the ropes
  std::optional<ConsistentMass> consistent_mass;
  AlignedVector<double> unit_mass;
  CoordinateVectors forces;   // workspace for the consistent mass: summed forces
  CoordinateVectors unmoved;  // dummy positions for kicks without drift

  // Components.
  AlignedVector<HingeBlock> hinges;
  std::vector<DynamicBody> bodies;
  std::vector<BodyControl> controls;
  double friction;  // coefficient of all contacts
  RopeDynamics ropes;
  RodWrinkling wrinkling;
  ContactSolver contacts;
  std::unique_ptr<CordContact> cord_contacts;  // null: cords pass through each other
  ContactedCoordinates contacted;
  MotionBound motion;
  // Motion since the last search for contacts: upper bounds (m) of the distance that any point of a cord (cords_way) or
  // of a body (bodies_way) has moved.
  double cords_way = 0;
  std::int64_t step_of_speed = -1;  // step that cord_speed is for; -1: outdated
  double cord_speed = 0;            // m/s, upper bound of the speed of any point of a cord
  double moved_speed = 0;           // m/s, the same for free coordinates, of their last update
  std::vector<double> bodies_way;
  std::vector<double> attachments_reach;       // m, by body: see reach_of_attachments
  std::vector<double> noted_rope_length;       // m, by rope: element length at the last note_motion
  std::unique_ptr<BodyContact> body_contacts;  // null: bodies pass through each other

  // Forces at the present state.
  AlignedVector<double> element_forces;
  AlignedVector<double> element_states;  // of the last compute_states
  std::int64_t step_of_states = -1;  // step of the last audit; -1: the state has changed in another way than by steps
  AppliedForces applied;             // all forces but those of elements
  std::vector<Wrench> wrenches;      // by body
  std::vector<SectorSum<Eigen::Vector3d>> hinge_torques;  // by body
  std::vector<std::vector<std::int32_t>>
      attached_blocks;                    // by body: blocks of coordinates that hold its attachments, ascending
  AlignedVector<double> attached_forces;  // forces on the attached blocks of one body
  BatchPower element_power;
  double hinge_power = 0;
  SafeguardCounts hinge_safeguards;
  std::int64_t step_of_forces = -1;  // step that the forces are for; -1: outdated
  double step_size_of_forces = 0;    // s, step size that the forces are for
  EnergyAudit last_audit;
  std::int64_t step_of_audit = -1;  // step that last_audit is for; -1: outdated
  std::vector<BatchPower> chunk_power;

  // Accounts since the start.
  SpentEnergy spent;
  double input_work = 0, initial_energy = 0, initial_input = 0;
  double reference_step = 0;                   // s, step that the stiffness of contacts is based on; 0: no step yet
  std::vector<Eigen::Vector3d> impulses;       // N s, by body: from cords
  std::vector<Eigen::Vector3d> body_impulses;  // N s, by body: from other bodies
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
  void set_friction(double coefficient);
  void set_length(std::size_t element, double length);
  bool moves(std::int32_t coordinate) const;
  bool ends_at_strain_partner(const BatchElement& element) const;
  void set_constant_loads();
  // A loop that the team's threads share; without a team, an ordinary loop.
  DividedLoop loop();
  // `meanwhile` runs on the caller's thread before that thread joins the loop over the elements.
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
  void fit_contacts(double dt);
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
  double strain_energy_of(std::size_t first, std::size_t last) const;  // J, of elements [first, last)
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
