#pragma once
// The instruction-set variants of hinge_forces.h for eight hinges at once, tested against it to round-off.

#include <cstddef>
#include <cstdint>

#include "engine/ancf/element_batch.h"

namespace netpocket {

// Eight hinges whose plane is kept by one body. Rows, then lanes; vectors in world axes.
struct alignas(64) HingeBlock {
  double rest_rotation[9][kBlockSize];  // by columns, body axes
  double stiffness[kBlockSize], damping[kBlockSize];

  // Filled by the kernel.
  double on_gradient1[3][kBlockSize], on_gradient2[3][kBlockSize];  // N m
  double torque_on_body[3][kBlockSize];                             // N m
  double dissipated_power[kBlockSize];                              // W
  double is_limited[kBlockSize];                                    // 1 where the damper is limited, else 0
  double is_loose[kBlockSize];  // 1 where a gradient is too short to be held firmly, else 0

  std::int32_t gradient1[kBlockSize], gradient2[kBlockSize];  // coordinates
  std::int32_t body = -1;                                     // -1: world axes
  std::int32_t count = 0;                                     // of hinges
};

namespace hinge_kernel {

struct Axes {
  double rotation[9];          // by columns, body axes to world axes
  double angular_velocity[3];  // rad/s
};

// `inverse_mass` by coordinate, 1/(kg m^2). Where a gradient is short, as in a cord that folds up, its direction turns
// so easily that an explicit damper would drive it: there damping is no stronger, against the inertia, than for
// gradients of unit length, unless it takes less than the angle's rate within the step, of which forces act over `kick`
// (s).
using Kernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities, const double* inverse_mass,
                        double kick, const Axes& axes, HingeBlock& block);

namespace baseline {
void forces(const CoordinateRows&, const CoordinateRows&, const double*, double, const Axes&, HingeBlock&);
}
namespace avx2 {
void forces(const CoordinateRows&, const CoordinateRows&, const double*, double, const Axes&, HingeBlock&);
}
namespace avx512 {
void forces(const CoordinateRows&, const CoordinateRows&, const double*, double, const Axes&, HingeBlock&);
}

}  // namespace hinge_kernel
}  // namespace netpocket
