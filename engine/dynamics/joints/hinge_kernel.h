#pragma once
// Instruction-set variants of hinge_forces.h for eight hinges at once. Tested against it to round-off.

#include <cstddef>
#include <cstdint>

#include "engine/ancf/element_batch.h"
#include "engine/math/instruction_set.h"

namespace netpocket {

// Up to eight hinges whose plane is kept by the same body. Rows, then lanes; vectors in world axes.
struct alignas(64) HingeBlock {
  double rest_rotation[9][kBlockSize];  // by columns, in body axes
  double stiffness[kBlockSize], damping[kBlockSize];

  // Results of the kernel.
  double on_gradient1[3][kBlockSize], on_gradient2[3][kBlockSize];  // N m
  double torque_on_body[3][kBlockSize];                             // N m
  double dissipated_power[kBlockSize];                              // W
  double is_limited[kBlockSize];                                    // 1 where the damping is limited, else 0
  double is_loose[kBlockSize];  // 1 where a gradient is too short to be held fully, else 0

  std::int32_t gradient1[kBlockSize], gradient2[kBlockSize];  // indices of coordinates
  std::int32_t body = -1;                                     // -1: the plane is fixed in world axes
  std::int32_t count = 0;                                     // number of hinges
};

namespace hinge_kernel {

struct Axes {
  double rotation[9];          // by columns, body axes to world axes
  double angular_velocity[3];  // rad/s
};

// Computes the results of a block. `inverse_mass`: by coordinate, 1/(kg m^2). `kick`: time (s) over which the forces
// act.
//
// Limit of damping. A short gradient, as in a cord that folds up, has little inertia against rotation, so an explicit
// damper could drive the motion. The damping is at most the larger of two values: that with the same ratio to the
// inertia as for gradients of unit length, and that which stops the angle's rate within the kick.
using Kernel = void (*)(const CoordinateRows& coordinates, const CoordinateRows& velocities, const double* inverse_mass,
                        double kick, const Axes& axes, HingeBlock& block);

NETPOCKET_VARIANTS(void forces(const CoordinateRows&, const CoordinateRows&, const double*, double, const Axes&,
                               HingeBlock&);)

}  // namespace hinge_kernel
}  // namespace netpocket
