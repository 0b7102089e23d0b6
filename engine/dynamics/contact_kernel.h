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
  double penetration[kBlockSize];                     // m
  double stiffness[kBlockSize], damping[kBlockSize];  // NormalLaw
  double velocity[3][kBlockSize];                     // m/s, of the cable relative to the body, before the step
  double force[3][kBlockSize];                        // N, on the cable
  std::int32_t slot[4][kBlockSize];
  std::int32_t place[4][kBlockSize];  // of the slot's block in ContactedSlots
  std::int32_t element[kBlockSize];
  std::int32_t body;
  std::int32_t count;  // of contacts; the lanes behind have no weight and no stiffness
};

namespace contact_kernel {

// Shape functions at a contact point of an element of unit length.
struct Sample {
  double position1, gradient1, position2, gradient2;
};

// World axes.
struct BodyMotion {
  double position[3], velocity[3];  // m, m/s, of the centre of mass
  double angular_velocity[3];       // rad/s
  double inverse_mass;              // 1/kg
  double inverse_inertia;           // 1/(kg m^2), largest
  double contacts;                  // that share the body's inertia
};

struct ForceView {
  const double* velocities;     // SlotRows
  const double* predicted;      // rows of ContactedSlots
  const double* shared_weight;  // likewise
  const double* inverse_mass;   // by slot, 1/kg
  double friction, friction_velocity, dt;
};

// Rows that `points` fills for each sample: x, y, z of the point, its distance from `centre`.
inline constexpr int kPointRows = 4;

// Contact points of the elements of a block. Returns the least distance.
using PointKernel = double (*)(const ElementBlock& block, const Sample* samples, std::size_t count,
                               const SlotRows& coordinates, const double* centre, double* rows);
// Velocity and force of contacts with one body.
using ForceKernel = void (*)(const ForceView& view, const BodyMotion& body, ContactBlock* contacts, std::size_t count);
// Power (W) that the contacts take out of the motion at these velocities.
using PowerKernel = double (*)(const SlotRows& velocities, const BodyMotion& body, const ContactBlock* contacts,
                               std::size_t count);

namespace baseline {
double points(const ElementBlock&, const Sample*, std::size_t, const SlotRows&, const double*, double*);
void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
double power(const SlotRows&, const BodyMotion&, const ContactBlock*, std::size_t);
}  // namespace baseline
namespace avx2 {
double points(const ElementBlock&, const Sample*, std::size_t, const SlotRows&, const double*, double*);
void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
double power(const SlotRows&, const BodyMotion&, const ContactBlock*, std::size_t);
}  // namespace avx2
namespace avx512 {
double points(const ElementBlock&, const Sample*, std::size_t, const SlotRows&, const double*, double*);
void forces(const ForceView&, const BodyMotion&, ContactBlock*, std::size_t);
double power(const SlotRows&, const BodyMotion&, const ContactBlock*, std::size_t);
}  // namespace avx512

}  // namespace contact_kernel
}  // namespace netpocket
