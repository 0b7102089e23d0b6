#pragma once
// The parameter table: every parameter of a Scenario, declared once. Reading, writing, range checks, "did you mean",
// the editor's form and scenarios/REFERENCE.md all come from it. Defaults are those of a default-constructed Scenario.
// Everything here is constant: any thread may use it.

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

// In the order of ParameterValue's alternatives.
enum class ParameterType { number, integer, boolean, text, choice, vector, pairs };

// One of a parameter's named choices.
struct Choice {
  int index = 0;  // into Parameter::choices
  bool operator==(const Choice&) const = default;
};

using ParameterValue =
    std::variant<double, std::int64_t, bool, std::string, Choice, Eigen::Vector3d, std::vector<Eigen::Vector2d>>;

// Limits of a number, of each number of a vector or list of pairs, or of the length of a text in characters.
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
  std::string_view key;  // "net.diameter"; a key without a dot stands at the top of the file
  ParameterType type;
  Limits limits;            // booleans and choices have none
  std::string_view unit;    // empty for dimensionless ones; "m, m" by column for pairs
  std::string_view help;    // one line
  std::string_view source;  // where the default comes from; "paper" is Tang et al. 2023
  std::span<const std::string_view> choices;

  // The value in a scenario.
  ParameterValue (*get)(const Scenario&);
  // Sets it. The value must hold the alternative of `type` (else std::bad_variant_access) and be within the limits.
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

// A TOML table and its parameters; the first group, with an empty name, is the top of the file.
struct ParameterGroup {
  std::string_view name;   // "net"
  std::string_view title;  // "Net cords"
  std::string_view help;   // one sentence
};

// All parameters, group by group in the order of the groups.
std::span<const Parameter> parameters();
std::span<const ParameterGroup> parameter_groups();
std::span<const Parameter> parameters_of(const ParameterGroup& group);

// Whether scenarios of earlier versions had this parameter: they stay readable, and what it says has no effect.
bool is_retired_parameter(std::string_view key);

// Null when there is no such parameter.
const Parameter* find_parameter(std::string_view key);
const ParameterGroup* find_parameter_group(std::string_view name);

// The parameter's key (the group's name) that somebody who wrote `unknown` most likely meant, if any is near.
std::optional<std::string_view> nearest_parameter_key(std::string_view unknown);
std::optional<std::string_view> nearest_group_name(std::string_view unknown);
std::optional<std::string_view> nearest_choice(const Parameter& parameter, std::string_view unknown);

}  // namespace netpocket
