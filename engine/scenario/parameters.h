#pragma once
// The parameter table declares every parameter of a Scenario once. Reading, writing, range checks, "did you mean", the
// editor's form and scenarios/REFERENCE.md all use it. Defaults are those of a default-constructed Scenario.
// Thread contract: everything here is constant, so any thread may use it.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/scenario/scenario.h"

namespace netpocket {

// In the order of the alternatives of ParameterValue.
enum class ParameterType { number, integer, boolean, text, choice, vector, pairs };

// Value of a parameter with named choices.
struct Choice {
  int index = 0;  // into Parameter::choices
  bool operator==(const Choice&) const = default;
};

using ParameterValue =
    std::variant<double, std::int64_t, bool, std::string, Choice, Eigen::Vector3d, std::vector<Eigen::Vector2d>>;

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
  std::string_view key;  // "net.diameter"; a key without a dot belongs to the top level of the file
  ParameterType type;
  Limits limits;            // unused by booleans and choices
  std::string_view unit;    // empty when dimensionless; for pairs one per column: "m, m"
  std::string_view help;    // one line
  std::string_view source;  // source of the default; "paper" is Tang et al. 2023
  std::span<const std::string_view> choices;

  // Gets the value from a scenario.
  ParameterValue (*get)(const Scenario&);
  // Sets the value in a scenario. It must hold the alternative of `type` (else throws std::bad_variant_access) and be
  // within the limits.
  void (*set)(Scenario&, const ParameterValue&);

  constexpr std::string_view group() const {
    const auto dot = key.find('.');
    return dot == key.npos ? std::string_view() : key.substr(0, dot);
  }
  constexpr std::string_view name() const {
    const auto dot = key.find('.');
    return dot == key.npos ? key : key.substr(dot + 1);
  }
};

// A TOML table of parameters. The first group has an empty name and is the top level of the file.
struct ParameterGroup {
  std::string_view name;   // "net"
  std::string_view title;  // "Net cords"
  std::string_view help;   // one sentence
};

// All parameters, group by group in the order of the groups.
std::span<const Parameter> parameters();
std::span<const ParameterGroup> parameter_groups();
std::span<const Parameter> parameters_of(const ParameterGroup& group);

// Whether scenarios of earlier versions had this parameter. Such scenarios stay readable; the value has no effect.
bool is_retired_parameter(std::string_view key);

// Null when there is no such parameter or group.
const Parameter* find_parameter(std::string_view key);
const ParameterGroup* find_parameter_group(std::string_view name);

// The existing key, group name or choice that the author of `unknown` most likely meant; nothing when none is similar.
std::optional<std::string_view> nearest_parameter_key(std::string_view unknown);
std::optional<std::string_view> nearest_group_name(std::string_view unknown);
std::optional<std::string_view> nearest_choice(const Parameter& parameter, std::string_view unknown);

}  // namespace netpocket
