#pragma once
// Steps a Model in time by explicit symplectic integration (leapfrog): cables, rigid bodies, hinges, variable-length
// ropes and contact. Keeps an account of all energy. World frame, SI units.
//
//   Model model;  ... nodes, cables, bodies ...
//   CableSystem system(model, {});
//   while (system.time() < 1) system.step(system.stable_step().step * 0.8);
//
// Positions and gradients belong to step n, velocities to step n - 1/2. The full evaluation throws
// std::invalid_argument on construction if its mass matrix is singular.
//
// Thread contract: one thread at a time per object. With options.threads > 1 a step uses that many threads inside; the
// result is the same to the last bit for any number.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/assembly/safeguards.h"
#include "engine/dynamics/assembly/stable_step.h"
#include "engine/dynamics/contact/contact_depth.h"
#include "engine/model/model.h"
#include "engine/state/snapshot.h"

namespace netpocket {

enum class ElementEvaluation {
  mean_strain,  // one axial strain per element, constant bending matrix, lumped mass: fast
  full          // 5 + 3 Gauss points, consistent mass: the reference
};

struct SystemOptions {
  ElementEvaluation evaluation = ElementEvaluation::mean_strain;
  int threads = 1;
  // Number of equal sectors around the y axis, numbered as model/sector_model.h says. While the system is symmetric,
  // one of them is stepped for all. 0: the whole system is stepped always.
  int sectors = 0;
};

// Whether one sector stands for all.
struct SymmetryStatus {
  bool is_symmetric = false;
  double since = 0;    // s
  std::string reason;  // why not, one clause; empty: it does, or was not asked to
};

// Energy (J) dissipated since the start. No part ever decreases.
struct SpentEnergy {
  double in_cords = 0;     // damping of cords, ropes, rods and lines
  double at_hinges = 0;    // dampers of hinges
  double in_contacts = 0;  // dampers of contacts, and impacts that contacts stop within a step
  double by_friction = 0;

  double total() const { return (in_cords + at_hinges) + (in_contacts + by_friction); }
};

// Energies (J) at one moment.
struct EnergyAudit {
  double kinetic = 0;
  double strain = 0;
  double contact = 0;  // stored in the springs of contacts
  double input = 0;    // work since the start: retractors, controls, gravity, the tide and loads
  double tidal = 0;    // of that, work of the tide of the model's orbit
  SpentEnergy spent;
  double error = 0;  // kinetic + strain + contact + spent - input, minus its value at the start
  // Aliased energy: the part of the cables' energy that the step does not resolve. For a wave of frequency w it is
  // (w dt/2)^2 of the wave's energy. The integrator conserves the total without this part, so `error` follows it.
  double aliased = 0;
};

// Contacts of cords, ropes and rods with each other.
struct CordContactSum {
  int count = 0;            // contact places
  double normal_force = 0;  // N, sum over the places
  double overlap = 0;       // largest overlap, as a fraction of the sum of the two radii
};

// Deepest contacts of cords.
struct ContactDepths {
  double penetration = 0;    // m, deepest penetration into a body
  ContactDepth pressed;      // deepest penetration into a body, relative to the cord's radius
  ContactDepth overlapping;  // deepest overlap with another cord, relative to the sum of the radii
};

// Contacts of rigid bodies with each other.
struct BodyContactSum {
  int count = 0;                                 // contact places
  double normal_force = 0;                       // N, sum over the places
  double penetration = 0;                        // m, deepest
  double stored = 0;                             // J, in the springs
  double damping_power = 0, friction_power = 0;  // W, dissipated at the present velocities
};

class CableSystem {
 public:
  // Throws std::invalid_argument with Model::find_fault()'s sentence when the model has a fault.
  explicit CableSystem(Model model, const SystemOptions& options = {});
  ~CableSystem();
  CableSystem(CableSystem&&) noexcept;
  CableSystem& operator=(CableSystem&&) noexcept;

  const Model& model() const;
  double time() const;  // s
  std::int64_t steps() const;
  double helpers_cpu_seconds() const;  // processor time (s) of the threads that help the caller's thread
  ElementEvaluation evaluation() const;
  SymmetryStatus symmetry() const;

  // Largest stable step at the present rope lengths, without a safety factor. Mean-strain elements are taken as
  // straight.
  StableStep stable_step();
  // Largest stable step (s) that also accounts for the stiffness from the cables' present bends and tensions.
  // `straight`: the result of stable_step() at about these rope lengths.
  double stable_step_as_bent(const StableStep& straight);
  // Advances the state by one step of `dt` (s). Steps may differ in size; large jumps cost accuracy.
  void step(double dt) { step(dt, dt); }
  // `spring_step` (s): springs of contacts are as stiff as steps of this size resolve.
  void step(double dt, double spring_step);
  // A sentence about the fault if the state is no longer finite or flies apart (100 km/s), else nothing. It names the
  // cable and its contact in the last step, or the body.
  std::optional<std::string> fault() const;

  Eigen::Vector3d position(std::int32_t node) const;  // m
  Eigen::Vector3d velocity(std::int32_t node) const;  // m/s, at the last half step
  Eigen::Vector3d gradient(std::int32_t gradient) const;
  BodyState body(std::int32_t body) const;
  // Motion of a body with its attachments, and the wrench that its control exerted in the last step. Both refer to the
  // common centre of mass of the body and its attachments.
  RigidMotion motion(std::int32_t body) const;
  const Wrench& exerted(std::int32_t body) const;
  // `rope`: as Model numbers ropes through. The motion is that of the present time.
  const RopeMotion& rope_motion(std::int32_t rope) const;
  // Tension (N) that winches of a rope feel, at present, for the velocities of the last half step: the mean of its
  // elements, or of the two end parts of a rope through rings.
  double rope_tension(std::int32_t rope) const;
  // The same (N) of the first ropes, by rope, in less time. Equal to round-off.
  void rope_tensions(std::span<double> tensions) const;
  // Natural lengths (m) and tensions (N) of the parts of a rope through rings, an index into Model::ring_ropes.
  std::vector<double> ring_rope_lengths(std::int32_t ring_rope) const;
  std::vector<double> ring_rope_tensions(std::int32_t ring_rope) const;

  // Displaces the free nodes (m, by node). To be called before the first step: energies count from the displaced state.
  void displace(std::span<const Eigen::Vector3d> displacements);
  // Sets what acts on a body from outside, from now on.
  void control(std::int32_t body, const BodyControl& control);
  // Releases a body that a lock of the model holds, and whether it is still held.
  void release(std::int32_t body);
  bool is_held(std::int32_t body) const;
  // Winds a rope: sets its motion at the end of the next step. It must follow from the present motion without a jump of
  // the length. Without this call a rope keeps its rate and acceleration. The work of winding counts as energy input.
  void wind(std::int32_t rope, const RopeMotion& motion);
  // Sets the coefficient of friction of all contacts.
  void set_friction(double coefficient);
  // Sets the wrinkling moment (N m) of the rods of a material. The change of their energy counts as energy input.
  void set_wrinkling_moment(std::int32_t material, double moment);

  // Impulse (N s) that contact with cables has given to a body since the start.
  const Eigen::Vector3d& contact_impulse(std::int32_t body) const;
  // Impulse (N s) that contact with other bodies has given to a body since the start.
  const Eigen::Vector3d& body_contact_impulse(std::int32_t body) const;
  // Contacts of bodies with each other in the last step.
  BodyContactSum body_contacts() const;
  // Contacts of cords with each other in the last step.
  CordContactSum cord_contacts() const;
  // Deepest contacts since the previous call.
  ContactDepths take_deepest_contacts();
  // Deepest penetration (m) of cords into bodies in the last step.
  double penetration() const;
  // Largest squared phase of a contact's spring in the last step, dt^2 w k (force_law.h); four times that of springs that
  // bear much.
  double contact_squared_phase() const;
  // Largest compression (m) of such a contact's spring. Springs that became stiffer begin below the surface.
  double contact_compression() const;
  // Largest force of a contact's spring by what the softest springs bear (contact_solver.h).
  double contact_load();
  // Step (s) that the stiffness of contacts is based on; 0 before the first step.
  double contact_step() const;
  // To be called by whoever chooses the steps, for each step that is shorter than stability requires.
  void note_shortened_step();
  const SafeguardCounts& safeguards() const;
  // The deepest contact of the last step, for messages, e.g. "rod 2 (element 31) is pressed 0.06 m into the target".
  // Empty without contact.
  std::string deepest_contact() const;

  // Gives every number of the state to `visit`, always in the same order. `visit` may read or replace the number, so
  // this one walk both saves and restores. A system restored from another's state continues as that one to the last
  // bit.
  void visit_state(const std::function<void(double&)>& visit);

  // Energies now. Evaluates the forces at most once; does not change the motion.
  EnergyAudit audit();
  // EnergyAudit::aliased (J) for a next step of `dt` (s). Evaluates the forces at most once; does not change the
  // motion.
  double aliased_energy(double dt);
  // Fills everything in `snapshot` but the channels, and returns the energies. Evaluates the forces at most once; does
  // not change the motion.
  EnergyAudit capture(Snapshot& snapshot);

 private:
  friend class SymmetricSector;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
