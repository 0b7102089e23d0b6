#pragma once
// The parameters that are members of Scenario. Every kind of capture system takes its choice of their tables.
// Internal to this room: use parameters.h.

#include <span>

#include "engine/scenario/parameters.h"

namespace netpocket {

std::span<const Parameter> shared_parameters();
std::span<const ParameterGroup> shared_groups();
std::span<const ParameterList> shared_lists();

}  // namespace netpocket
