#pragma once
// The instruction-set variants of what contact with bodies computes for eight cables at once. Internal to
// ContactSolver.

#include <cstddef>
#include <cstdint>

#include "engine/ancf/element_batch.h"

namespace netpocket {

// Eight contacts of cables with one body. Rows by coordinate or by corner of the cable's element, then lanes.
struct alignas(64) ContactBlock {
  double weight[4][kBlockSize];  // shape functions at the contact point
  double point[3][kBlockSize];   // m, on the cable's axis: where the force acts on both, so that their moments balance
  double normal[3][kBlockSize];  // outward from the body
  double penetration[kBlockSize];                     // m; negative: still apart, but within the step's way
  double stiffness[kBlockSize], damping[kBlockSize];  // NormalLaw
  double deepest[kBlockSize];                         // m, penetration that no approach may pass
  double share[kBlockSize];                           // of the cord's contact there, 0 to 1
  double force[3][kBlockSize];                        // N, on the cable
  double normal_force[kBlockSize];                    // N, >= 0
  double elastic[kBlockSize];                         // N, of the spring alone
  double is_stopped[kBlockSize];     // 1 where the force ends the approach at the greatest depth, else 0
  double is_unresolved[kBlockSize];  // 1 where the spring is too stiff for the step (force_law.h: theta > 0), else 0
  double damping_power[kBlockSize], friction_power[kBlockSize];  // W, at the velocities before the step (PowerKernel)
  std::int32_t coordinate[4][kBlockSize];
  std::int32_t place[4][kBlockSize];  // of the coordinate's block in ContactedCoordinates
  std::int32_t element[kBlockSize];
  std::int32_t body;
  std::int32_t count;  // of contacts; the lanes behind have no weight and no stiffness
};

namespace contact_kernel {

// Shape functions at a vertex of the chain of capsules, for an element of unit length.
struct Vertex {
  double position1, gradient1, position2, gradient2;
};

// World axes.
struct BodyMotion {
  double position[3], velocity[3];  // m, m/s, of the centre of mass
  double angular_velocity[3];       // rad/s
  double inverse_mass;              // 1/kg
  double inverse_inertia[3][3];     // 1/(kg m^2), about the centre of mass
  double largest_inverse_inertia;   // its largest eigenvalue
  double contacts;                  // that share the body's inertia: the sum of their shares
};

struct ForceView {
  const double* velocities;     // CoordinateRows
  const double* predicted;      // rows of ContactedCoordinates
  const double* shared_weight;  // likewise
  const double* inverse_mass;   // by coordinate, 1/kg
  double friction, friction_velocity, dt;
  double inertia_factor;  // of StepTimes
};

// Vertices (m) of the chains of the elements of a block into three rows each (x, y, z), `count` of them, then a row
// with a lower bound of each chain's distance from `centre`.
using VertexKernel = void (*)(const ElementBlock& block, const Vertex* vertices, std::size_t count,
                              const CoordinateRows& coordinates, const double* centre, double* rows);
// Where the chains of four capsules of eight elements touch a sphere that is much larger than a capsule is long, by the
// points that share an element (contact_search.h): its first node, its middle, its second node.
struct alignas(64) SpherePlaces {
  double clearance[kBlockSize];  // m, of the surfaces; the rest is unset where all of a part are positive
  double place[3][kBlockSize];   // segment and way along it, 0 to 4
  double depth[3][kBlockSize];   // m; not positive: no contact
  double share[3][kBlockSize];
};
// `vertices`: rows as VertexKernel fills them, of five vertices. `thickness`: by lane, the sphere's radius and the
// cord's (m). `centre` of the sphere.
using SphereKernel = void (*)(const double* vertices, const double* centre, const double* thickness,
                              SpherePlaces& places);
// Forces of contacts with one body.
using ForceKernel = void (*)(const ForceView& view, const BodyMotion& body, ContactBlock* contacts, std::size_t count);
// What contacts take out of the motion at these velocities, W.
struct ContactPower {
  double damping = 0;  // by the dampers, and by what stops a cord within a step
  double friction = 0;

  ContactPower& operator+=(const ContactPower& other) {
    damping += other.damping;
    friction += other.friction;
    return *this;
  }
};
using PowerKernel = ContactPower (*)(const CoordinateRows& velocities, const BodyMotion& body,
                                     const ContactBlock* contacts, std::size_t count);

namespace baseline {
void vertices(const ElementBlock&, const Vertex*, std::size_t, const CoordinateRows&, const double*, double*);
void sphere_places(const double*, const double*, const double*, SpherePlaces&);
void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
ContactPower power(const CoordinateRows&, const BodyMotion&, const ContactBlock*, std::size_t);
}  // namespace baseline
namespace avx2 {
void vertices(const ElementBlock&, const Vertex*, std::size_t, const CoordinateRows&, const double*, double*);
void sphere_places(const double*, const double*, const double*, SpherePlaces&);
void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
ContactPower power(const CoordinateRows&, const BodyMotion&, const ContactBlock*, std::size_t);
}  // namespace avx2
namespace avx512 {
void vertices(const ElementBlock&, const Vertex*, std::size_t, const CoordinateRows&, const double*, double*);
void sphere_places(const double*, const double*, const double*, SpherePlaces&);
void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
ContactPower power(const CoordinateRows&, const BodyMotion&, const ContactBlock*, std::size_t);
}  // namespace avx512

}  // namespace contact_kernel
}  // namespace netpocket
