#pragma once
// Parameters that a scenario has but does not use, as the length of a target that is a sphere.
// Thread contract: any thread may call it.

#include <string_view>

#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// One sentence, such as "Used for cylinders."; empty when the scenario uses the parameter, which is one of its own.
std::string_view why_parameter_unused(const Parameter& parameter, const Scenario& scenario);

}  // namespace netpocket
