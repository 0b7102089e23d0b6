#pragma once
// A setting of a study: a value for a parameter, or for one number of a parameter that is a list.

#include <string>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

struct Setting {
  std::string key;    // "target.radius"; "target.position[0]"; "rods.profile[1][0]"; indices begin at 0
  std::string value;  // in TOML syntax

  bool operator==(const Setting&) const = default;
};

// On error the scenario is unchanged. Errors: unknown key, index outside the list, wrong type, value outside the
// limits. Thread contract: any thread may call it.
Diagnostics apply_setting(Scenario& scenario, const Setting& setting);

// Applies all settings in their order. Stops at the first that fails and returns its problems; earlier ones stay
// applied.
Diagnostics apply_settings(Scenario& scenario, const std::vector<Setting>& settings);

}  // namespace netpocket
