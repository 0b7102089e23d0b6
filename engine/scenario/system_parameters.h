#pragma once
// The parameters of a kind of capture system: the tables of Scenario that it uses, and tables of its own.
//
// Thread contract: kinds must be registered before other threads use parameters.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/bodies/shape.h"
#include "engine/scenario/parameters.h"

namespace netpocket {

struct SystemParameters {
  std::string_view name;   // "pocket", as scenarios have it
  std::string_view title;  // "Netted pocket"
  std::string_view help;   // one sentence
  // Names of the tables of Scenario that it uses, beside those that every kind has: the top level, orbit, solver and
  // output.
  std::vector<std::string_view> shared_groups;
  std::vector<std::string_view> shared_lists = {};  // likewise, of lists of tables
  std::vector<ParameterGroup> groups = {};          // its own tables; they follow the shared ones
  std::vector<Parameter> parameters = {};           // of these tables, group by group, made by own_parameter
  // Adds what is wrong beyond limits, inertia, the target's shape and output. Called when every parameter is within its
  // limits. `target`: its shape; null if the kind has no target or the shape is not valid. May be null.
  void (*check)(const Scenario& scenario, const Shape* target, Diagnostics& problems) = nullptr;
  // Whether a change of this parameter can act on a run in progress. Null: none but output.end_time.
  bool (*acts_at_once)(std::string_view key) = nullptr;
};

// A parameter that a Scenario keeps by its key. The views must live as long as the program. `initial`: its default,
// which also decides the type.
Parameter own_parameter(std::string_view key, ParameterValue (*initial)(), Limits limits, std::string_view unit,
                        std::string_view help, std::string_view source, std::span<const std::string_view> choices = {});

const SystemParameters& pocket_parameters();

// Makes a kind known. `parameters` must live as long as the program. Throws std::invalid_argument when a kind of this
// name exists, or when a shared group does not.
void register_system_parameters(const SystemParameters& parameters);

// Null when there is no such kind.
const SystemParameters* find_system(std::string_view name);
std::span<const std::string_view> system_names();

}  // namespace netpocket
