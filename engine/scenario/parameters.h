#pragma once
// The parameter tables declare every parameter of a Scenario once. Reading, writing, range checks, "did you mean", the
// editor's form and scenarios/REFERENCE.md all use them. Each kind of capture system has a table of its own
// (system_parameters.h); functions without the name of a kind use the table of the pocket. Defaults are those of a
// default-constructed Scenario.
// Thread contract: everything here is constant once all kinds are registered, so any thread may use it.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/scenario/parameter_value.h"
#include "engine/scenario/scenario.h"

namespace netpocket {

// Limits of a number, of each number of a vector or list of pairs, or of the length of a text (characters).
struct Limits {
  double minimum = 0;
  double maximum = 0;
  bool minimum_excluded = false;

  // False for NaN.
  constexpr bool contain(double value) const {
    return (minimum_excluded ? value > minimum : value >= minimum) && value <= maximum;
  }
};

struct Parameter {
  // "net.diameter"; a key without a dot belongs to the top level of the file; "controller.0.rate" to an item of a list.
  std::string_view key;
  ParameterType type;
  Limits limits;            // unused by booleans and choices
  std::string_view unit;    // empty when dimensionless; for pairs one per column: "m, m"
  std::string_view help;    // one line
  std::string_view source;  // source of the default; "paper" is Tang et al. 2023
  std::span<const std::string_view> choices;

  ParameterValue (*read)(const Scenario&, const Parameter&);
  void (*write)(Scenario&, const Parameter&, const ParameterValue&);
  ParameterValue (*initial)() = nullptr;  // default of a parameter that a Scenario keeps by its key; else null
  std::size_t item = 0;                   // of an item of a list: its index

  // Gets the value from a scenario. An item must exist, else throws std::out_of_range; so does `set`.
  ParameterValue get(const Scenario& scenario) const { return read(scenario, *this); }
  // Sets the value in a scenario. It must hold the alternative of `type` (else throws std::bad_variant_access) and be
  // within the limits.
  void set(Scenario& scenario, const ParameterValue& value) const { write(scenario, *this, value); }

  constexpr std::string_view group() const {
    const auto dot = key.find('.');
    return dot == key.npos ? std::string_view() : key.substr(0, dot);
  }
  constexpr std::string_view name() const {
    const auto dot = key.rfind('.');
    return dot == key.npos ? key : key.substr(dot + 1);
  }
};

// A TOML table of parameters. The first group has an empty name and is the top level of the file.
struct ParameterGroup {
  std::string_view name;   // "net"
  std::string_view title;  // "Net cords"
  std::string_view help;   // one sentence
};

// A list of TOML tables with the same parameters, each of which is an item: [[controller]].
struct ParameterList {
  std::string_view name;            // "controller", "actuators.thruster"
  std::string_view title;           // "Controllers"
  std::string_view help;            // one sentence
  std::span<const Parameter> rows;  // keys without index: "controller.rate"
  std::size_t (*size)(const Scenario&);
  void (*resize)(Scenario&, std::size_t);  // new items have their defaults
};

// A list with more items is refused.
inline constexpr std::size_t kMostItems = 32;

inline constexpr std::string_view kPocketSystem = "pocket";

// All parameters of a kind of capture system, group by group in the order of the groups. For a kind that does not
// exist: those of the pocket.
std::span<const Parameter> parameters(std::string_view system = kPocketSystem);
std::span<const ParameterGroup> parameter_groups(std::string_view system = kPocketSystem);
std::span<const Parameter> parameters_of(const ParameterGroup& group, std::string_view system = kPocketSystem);

std::span<const ParameterList> parameter_lists(std::string_view system = kPocketSystem);
// Those of an item, which need not exist; `item` below kMostItems.
std::span<const Parameter> parameters_of(const ParameterList& list, std::size_t item);
// All parameters of a scenario: those of its kind of capture system and those of the items that it has.
std::vector<const Parameter*> parameters_of(const Scenario& scenario);

// Whether scenarios of earlier versions had this parameter. Such scenarios stay readable; the value has no effect.
bool is_retired_parameter(std::string_view key);

// Null when there is no such parameter or group.
const Parameter* find_parameter(std::string_view key, std::string_view system = kPocketSystem);
const ParameterGroup* find_parameter_group(std::string_view name, std::string_view system = kPocketSystem);
const ParameterList* find_parameter_list(std::string_view name, std::string_view system = kPocketSystem);
// Also finds the parameters of items that the scenario has.
const Parameter* find_parameter(std::string_view key, const Scenario& scenario);

// The existing key, name of a group or list, or choice that the author of `unknown` most likely meant; nothing when
// none is similar.
std::optional<std::string_view> nearest_parameter_key(std::string_view unknown,
                                                      std::string_view system = kPocketSystem);
std::optional<std::string_view> nearest_group_name(std::string_view unknown, std::string_view system = kPocketSystem);
std::optional<std::string_view> nearest_choice(const Parameter& parameter, std::string_view unknown);

}  // namespace netpocket
