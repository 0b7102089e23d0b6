#pragma once
// A setting of a study: a value for a parameter, or for one number of a parameter that is a list.

#include <optional>
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

// The number that a key of a Setting names in a scenario; nothing when it names no single number.
std::optional<double> number_of(const Scenario& scenario, const std::string& key);

// The value, in TOML syntax, that a key of a Setting has in a scenario. The key must be that of a parameter or of a
// number of one.
std::string value_of(const Scenario& scenario, const std::string& key);

}  // namespace netpocket
