#pragma once
// The tables of closed-loop control. Internal to this room: use parameters.h.

#include <span>

#include "engine/scenario/parameters.h"

namespace netpocket {

std::span<const Parameter> control_parameters();  // of [winch] and [actuators]
std::span<const ParameterGroup> control_groups();
std::span<const ParameterList> control_lists();

}  // namespace netpocket
