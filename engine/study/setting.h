#pragma once
// One value of a study: a parameter, or one number of a parameter that is a list, and what it is set to.

#include <string>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

struct Setting {
  std::string key;    // "target.radius"; "target.position[0]"; "rods.profile[1][0]", counted from 0
  std::string value;  // as TOML writes it

  bool operator==(const Setting&) const = default;
};

// On error (unknown key, no such number in the list, wrong type, outside the limits) the scenario stays as it was. Any
// thread may call it.
Diagnostics apply_setting(Scenario& scenario, const Setting& setting);

// All of them in their order, or the first problem.
Diagnostics apply_settings(Scenario& scenario, const std::vector<Setting>& settings);

}  // namespace netpocket
