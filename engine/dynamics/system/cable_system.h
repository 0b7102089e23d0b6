#pragma once
// Steps a Model in time: explicit symplectic integration (leapfrog) of cables, rigid bodies, hinges, variable-length
// ropes and contact, with an account of all energy.
//
//   Model model;  ... nodes, cables, bodies ...
//   CableSystem system(model, {});
//   while (system.time() < 1) system.step(system.stable_step().step * 0.8);
//
// Thread contract: one thread at a time per object. With options.threads > 1 a step uses that many threads inside; the
// result is the same to the last bit for any number.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

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
};

// J, spent since the start. No part ever falls.
struct SpentEnergy {
  double in_cords = 0;     // damping of cords, ropes and rods
  double at_hinges = 0;    // their dampers
  double in_contacts = 0;  // dampers of contacts, and blows that they stop within a step
  double by_friction = 0;

  double total() const { return (in_cords + at_hinges) + (in_contacts + by_friction); }
};

// J, at one moment.
struct EnergyAudit {
  double kinetic = 0;
  double strain = 0;
  double contact = 0;  // in the springs of contacts
  double input = 0;    // work of retractors, controls, gravity and loads since the start
  SpentEnergy spent;
  double error = 0;  // kinetic + strain + contact + spent - input, less its value at the start
  // Of the cables' motion, what a step does not resolve: of a wave of frequency w, (w dt/2)^2 of its energy. The
  // integrator conserves the kinetic energy without it, so that the error follows it to and fro.
  double aliased = 0;
};

// Of cords, ropes and rods that touch each other.
struct CordContactSum {
  int count = 0;            // places
  double normal_force = 0;  // N, sum over these
  double overlap = 0;       // the deepest penetration, of the sum of the two radii
};

// The deepest contacts of cords.
struct ContactDepths {
  double penetration = 0;    // m, in bodies
  ContactDepth pressed;      // into a body, deepest by its radius
  ContactDepth overlapping;  // with another cord
};

// Of rigid bodies that touch each other.
struct BodyContactSum {
  int count = 0;                                 // places
  double normal_force = 0;                       // N, sum over these
  double penetration = 0;                        // m, the deepest
  double stored = 0;                             // J, in their springs
  double damping_power = 0, friction_power = 0;  // W, taken out of the motion at the present velocities
};

class CableSystem {
 public:
  explicit CableSystem(Model model, const SystemOptions& options = {});
  ~CableSystem();
  CableSystem(CableSystem&&) noexcept;
  CableSystem& operator=(CableSystem&&) noexcept;

  const Model& model() const;
  double time() const;  // s
  std::int64_t steps() const;
  double helpers_cpu_seconds() const;  // processor time of the threads that help the caller's, s
  ElementEvaluation evaluation() const;

  // Largest stable step at the present rope lengths, without a safety factor.
  StableStep stable_step();
  // The same (s) with what the present bends and tensions of the cables add to the stiffness; `straight`: stable_step()
  // at about these rope lengths.
  double stable_step_as_bent(const StableStep& straight);
  // One step of `dt` (s). Steps may differ in size; large jumps cost accuracy.
  void step(double dt);
  // What is wrong with the state, if it is no longer finite or flies apart: one sentence that names the cable, its
  // contact in the last step, or the body.
  std::optional<std::string> fault() const;

  Eigen::Vector3d position(std::int32_t node) const;  // m
  Eigen::Vector3d velocity(std::int32_t node) const;  // m/s, at the last half step
  Eigen::Vector3d gradient(std::int32_t gradient) const;
  BodyState body(std::int32_t body) const;
  // Of a body with what is attached to it, and what its control exerted in the last step, about their common centre.
  RigidMotion motion(std::int32_t body) const;
  const Wrench& exerted(std::int32_t body) const;
  const RopeMotion& rope_motion(std::int32_t rope) const;

  // Moves the free nodes (m, by node) before the first step; energies count from the state so made.
  void displace(std::span<const Eigen::Vector3d> displacements);
  // Imposed on a body from now on.
  void control(std::int32_t body, const BodyControl& control);
  // Replaces the law of winding of all ropes from now on.
  void set_rope_motion(const std::function<RopeMotion(double)>& motion);
  void set_friction(double coefficient);
  // Wrinkling moment (N m) of the rods of a material. The change of their energy counts as work put in.
  void set_wrinkling_moment(std::int32_t material, double moment);

  // Impulse (N s) that contact with cables has given to a body since the start.
  const Eigen::Vector3d& contact_impulse(std::int32_t body) const;
  // Impulse (N s) that contact with other bodies has given to a body since the start.
  const Eigen::Vector3d& body_contact_impulse(std::int32_t body) const;
  // Contacts of bodies with each other in the last step.
  BodyContactSum body_contacts() const;
  // Contacts of cords with each other in the last step.
  CordContactSum cord_contacts() const;
  // Those since the previous call.
  ContactDepths take_deepest_contacts();
  // Deepest penetration (m) of the last step.
  double penetration() const;
  // Step (s) that the stiffness of contacts is for; 0 before the first one.
  double contact_step() const;
  // Whoever chooses the steps tells of each that is shorter than stability asks for.
  void note_shortened_step();
  const SafeguardCounts& safeguards() const;
  // Of the last step, for messages: e.g. "rod 2 (element 31) is pressed 0.06 m into the target"; empty without contact.
  std::string deepest_contact() const;

  // Gives every number of the state to `visit`, always in the same order, which may read it or replace it: saving and
  // restoring are the same walk. A system restored from another's state continues to the last bit as that one does.
  void visit_state(const std::function<void(double&)>& visit);

  // Energies now. Evaluates the forces once; does not change the motion.
  EnergyAudit audit();
  // EnergyAudit::aliased (J) of a step of `dt` (s) from now on. Evaluates the forces once; does not change the
  // motion.
  double aliased_energy(double dt);
  // Fills everything but the channels and returns the energies. Evaluates the forces once; does not change the motion.
  EnergyAudit capture(Snapshot& snapshot);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
