#pragma once
// Reads scenarios from TOML. Keys that a file omits keep the defaults of Scenario. Errors are returned as values with
// file, line and key; nothing is thrown. Only each parameter by itself is checked here; check_scenario.h checks
// combinations.
// Thread contract: any thread may call these functions.

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

struct ScenarioResult {
  Scenario scenario{};                              // complete only if ok()
  Diagnostics diagnostics{};                        // sorted by line; at most twenty problems are listed
  std::map<std::string, int, std::less<>> lines{};  // of the file, by the keys that it states, and by lists

  bool ok() const { return diagnostics.ok(); }
  // The problems that check_scenario found, with the file and the line of each key or, where the file does not state
  // the key of a list's item, of that item.
  Diagnostics with_lines(const Diagnostics& problems, const std::string& file) const;
};

// Larger files are refused unread.
inline constexpr std::size_t kLargestScenarioFile = 1'000'000;  // bytes

// A scenario without a `name` is named after its file ("case1.toml": "case1"). Files that it names are sought in its
// folder.
ScenarioResult read_scenario_file(const std::string& path);

// Absolute path of the folder of a scenario's file, for Scenario::files.
std::string folder_of(const std::string& path);

// `name`: used as the file name in diagnostics.
ScenarioResult read_scenario_text(std::string_view text, const std::string& name);

// Sets one parameter from text: a TOML value. The quotes of texts and choices may be omitted. On error the scenario is
// unchanged.
Diagnostics set_parameter(Scenario& scenario, const Parameter& parameter, std::string_view text);

// Applies "key=value", as in `--set net.diameter=0.006`. On error the scenario is unchanged. A file named in this way
// may have an absolute path, because the user chose it and not the author of the scenario.
Diagnostics apply_setting(Scenario& scenario, std::string_view setting);

}  // namespace netpocket
