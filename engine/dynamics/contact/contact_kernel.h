#pragma once
// Instruction-set variants of contact between cables and bodies, for eight contacts at once. Internal to ContactSolver.

#include <cstddef>
#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/math/instruction_set.h"

namespace netpocket {

// Up to eight contacts of cables with one body. Arrays are ordered by component or by corner of the cable's element,
// then by lane. Lanes without a contact are zero. See contact_blocks.h for their lanes.
struct alignas(64) ContactBlock {
  double weight[4][kBlockSize];  // shape functions at the contact point
  double point[3][kBlockSize];   // m, on the cable's axis; the force acts there on cable and body, so moments balance
  double normal[3][kBlockSize];  // outward from the body
  double
      penetration[kBlockSize];  // m, from where the spring begins; negative: still apart, but may touch within the step
  double offset[kBlockSize];    // m, depth at which the spring begins (contact_solver.h)
  double stiffness[kBlockSize], damping[kBlockSize];  // as in NormalLaw
  double deepest[kBlockSize];                         // m, greatest depth: no approach may pass it
  double share[kBlockSize];                           // weight of the contact (holder_touches.h), 0 to 1
  double force[3][kBlockSize];                        // N, on the cable
  double normal_force[kBlockSize];                    // N, >= 0
  double elastic[kBlockSize];                         // N, of the spring alone
  double is_stopped[kBlockSize];     // 1 where the force stops the approach at the greatest depth, else 0
  double squared_phase[kBlockSize];  // dt^2 w k of the spring; above 1 it is too stiff for the step (force_law.h)
  double damping_power[kBlockSize], friction_power[kBlockSize];  // W, at the velocities before the step (PowerKernel)
  std::int32_t coordinate[4][kBlockSize];
  std::int32_t place[4][kBlockSize];  // index of the coordinate's block in ContactedCoordinates
  // Whether all lanes read whole blocks of coordinates, as ElementBlock does with its members of these names. All lanes
  // of a corner then have the same place.
  bool is_regular;
  std::int32_t base[4], rotation[4];
  std::int32_t element[kBlockSize];
  std::int32_t part[kBlockSize], holder[kBlockSize];  // of the body; of the cord (contact_holders.h)
  bool is_cord_end[kBlockSize];                       // whether the holder is an end of the cord
  bool is_extra[kBlockSize];                          // CordTouch::is_extra
  std::int32_t body;
  bool feeds;          // whether any contact is on an element of variable length
  std::uint32_t used;  // bit i: lane i holds a contact
};

namespace contact_kernel {

// Shape functions at a vertex of the capsule chain, for an element of unit length.
struct Vertex {
  double position1, gradient1, position2, gradient2;
};

// Motion and inertia of a body, world axes.
struct BodyMotion {
  double position[3], velocity[3];  // m, m/s, of the centre of mass
  double angular_velocity[3];       // rad/s
  double inverse_mass;              // 1/kg
  double inverse_inertia[3][3];     // 1/(kg m^2), about the centre of mass
  double largest_inverse_inertia;   // 1/(kg m^2), largest eigenvalue of the inverse inertia
  double contacts;                  // sum of the shares of all contacts with the body, which share its inertia
};

struct ForceView {
  const double* velocities;     // CoordinateRows
  const double* predicted;      // predicted velocities, rows of ContactedCoordinates
  const double* shared_weight;  // sums of weights, of ContactedCoordinates
  const double* inverse_mass;   // by coordinate, 1/kg or 1/(kg m^2)
  double friction, friction_velocity, dt;
  double inertia_factor;  // StepTimes::inertia_factor()
};

// Computes the `count` vertices (m) of the capsule chains of a block's elements, three rows each (x, y, z). Then
// follows a row with a lower bound (m) of each chain's distance from `centre`.
using VertexKernel = void (*)(const ElementBlock& block, const Vertex* vertices, std::size_t count,
                              const CoordinateRows& coordinates, const double* centre, double* rows);
// Computes the forces of `count` blocks of contacts with one body.
using ForceKernel = void (*)(const ForceView& view, const BodyMotion& body, ContactBlock* contacts, std::size_t count);
// Adds to `shared_weight`, sums of ContactedCoordinates, the weights of contacts on their coordinates. All contacts of
// a corner come before those of the next. So the order at any one coordinate is the same in every sector.
using ShareKernel = void (*)(const ContactBlock* contacts, std::size_t count, double* shared_weight);
// Adds the forces of contacts to rows of forces on coordinates (CoordinateRows), in the same order.
using ApplyKernel = void (*)(const ContactBlock* contacts, std::size_t count, double* forces);
// Sums, by lane, of the forces and torques (about `centre`) of contacts on their body.
struct alignas(64) BodyForces {
  double force[3][kBlockSize], torque[3][kBlockSize];
};
using BodyKernel = void (*)(const ContactBlock* contacts, std::size_t count, const double* centre, BodyForces& sums);
// Power (W) that contacts take out of the motion at given velocities.
struct ContactPower {
  double damping = 0;  // by dampers, and by stopping a cord within a step
  double friction = 0;

  ContactPower& operator+=(const ContactPower& other) {
    damping += other.damping;
    friction += other.friction;
    return *this;
  }
};
// The negative powers of each lane, W.
struct alignas(64) LanePowers {
  double damping[kBlockSize], friction[kBlockSize];
};
using PowerKernel = void (*)(const CoordinateRows& velocities, const BodyMotion& body, const ContactBlock* contacts,
                             std::size_t count, LanePowers* powers);

NETPOCKET_VARIANTS(void vertices(const ElementBlock&, const Vertex*, std::size_t, const CoordinateRows&, const double*,
                                 double*);
                   void share(const ContactBlock*, std::size_t, double*);
                   void apply(const ContactBlock*, std::size_t, double*);
                   void forces_on_body(const ContactBlock*, std::size_t, const double*, BodyForces&);
                   void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
                   void power(const CoordinateRows&, const BodyMotion&, const ContactBlock*, std::size_t, LanePowers*);)

}  // namespace contact_kernel
}  // namespace netpocket
