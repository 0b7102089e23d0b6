#pragma once
// Instruction-set variants of contact between cables and spheres much larger than a capsule, for eight elements at
// once. Internal to ContactSearch and ContactSolver.

#include <cstdint>

#include "engine/dynamics/contact/contact_kernel.h"

namespace netpocket {

// Places of eight elements at one of their holders of contact (contact_holders.h). Rows are ordered by lane.
struct alignas(64) TouchRows {
  TouchRows() {}  // not defaulted: with that, all rows would first be set to zero

  double depth[kBlockSize];    // m; zero or negative: no contact, and the other rows have no meaning
  double share[kBlockSize];    // weight of the holder there, 0 to 1
  double score[kBlockSize];    // as WeightedPlace::score
  double segment[kBlockSize];  // index of the capsule
  double t[kBlockSize];        // position along it, 0 to 1
  double point[3][kBlockSize], normal[3][kBlockSize];  // on the axis; outward from the sphere
};

// What a contact's law (force_law.h) needs, by lane.
struct alignas(64) LawRows {
  double stiffness[kBlockSize], damping[kBlockSize];  // as in NormalLaw
  double impact[kBlockSize];                          // m, compression that no approach may pass
  double deepest[kBlockSize];                         // m, depth that no approach may pass
};

namespace sphere_kernel {

// Places where the chains of four capsules of eight elements touch a sphere, by holder: the element's first node, its
// middle, its second node.
struct alignas(64) SpherePlaces {
  double clearance[kBlockSize];  // m, between the surfaces; rows are not set where all clearances of a SIMD part are
                                 // positive
  TouchRows holder[3];
};
// `vertices`: rows of five vertices, as contact_kernel::VertexKernel fills them. `thickness`: by lane, radius of the
// sphere plus radius of the cord (m). `centre`: of the sphere (m).
using PlacesKernel = void (*)(const double* vertices, const double* centre, const double* thickness,
                              SpherePlaces& places);
// Sets all rows of `contacts` that a law and a place determine, for contacts in the lanes `used` of springs that begin
// at the surface. `vertices`: shape functions at the five vertices. `length`: by lane, of the elements (m).
using PlacingKernel = void (*)(const TouchRows& touches, std::uint32_t used, const LawRows& laws,
                               const contact_kernel::Vertex* vertices, const double* length, ContactBlock& contacts);

NETPOCKET_VARIANTS(void places(const double*, const double*, const double*, SpherePlaces&);
                   void place(const TouchRows&, std::uint32_t, const LawRows&, const contact_kernel::Vertex*,
                              const double*, ContactBlock&);)

}  // namespace sphere_kernel
}  // namespace netpocket
