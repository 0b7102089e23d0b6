#pragma once
// Reads scenarios from TOML. Keys that a file leaves out keep the defaults of Scenario. Errors are values, with file,
// line and key; nothing is thrown. What is checked here is each parameter by itself; check_scenario.h checks how they
// go together. Any thread may call these functions.

#include <string>
#include <string_view>

#include "engine/base/diagnostics.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

struct ScenarioResult {
  Scenario scenario{};        // complete only if ok()
  Diagnostics diagnostics{};  // by line; after twenty problems the rest is not listed

  bool ok() const { return diagnostics.ok(); }
};

// Files larger than this are refused, unread.
inline constexpr std::size_t kLargestScenarioFile = 1'000'000;  // bytes

// A scenario without a `name` is named after its file ("case1.toml": "case1"). Files that it names are looked for in
// its folder.
ScenarioResult read_scenario_file(const std::string& path);

// The folder of a scenario's file, for Scenario::files.
std::string folder_of(const std::string& path);

// `name` stands for the file in the diagnostics.
ScenarioResult read_scenario_text(std::string_view text, const std::string& name);

// Sets one parameter from text: a TOML value; for texts and choices the quotes may be left out. On error the scenario
// stays as it was.
Diagnostics set_parameter(Scenario& scenario, const Parameter& parameter, std::string_view text);

// Applies "key=value", as in `--set net.diameter=0.006`. On error the scenario stays as it was. A file named in this
// way may have an absolute path: the user chose it, not the scenario's author.
Diagnostics apply_setting(Scenario& scenario, std::string_view setting);

}  // namespace netpocket
