#pragma once
// Stops contacts of cords with a body at their greatest depth. Internal to ContactSolver.

#include <span>

#include "engine/bodies/rigid_body.h"
#include "engine/contact/force_law.h"
#include "engine/dynamics/contact/contact_kernel.h"
#include "engine/dynamics/contact/contacted_coordinates.h"

namespace netpocket {

// Completes the forces that stop contacts at their greatest depth. The kernel stops each approach by itself, with its
// share of the inertia. Where neighbours need other forces, a part of the approach remains, which may be enough to pass
// through a thin wall. So forces are added from the velocities that they lead to, until no approach remains. The row
// sums of mass splitting (contacted_coordinates.h) make this converge.
//
// `places`: of the body's contacts, in order: index of the block in `contacts` * kBlockSize + lane. `shares`: sum of
// the shares of all contacts with the body, which share its inertia.
void complete_stops(std::span<ContactBlock> contacts, std::span<const std::int32_t> places, const RigidBody& body,
                    double shares, ContactedCoordinates& contacted, std::span<const double> inverse_mass,
                    const StepTimes& times);

}  // namespace netpocket
