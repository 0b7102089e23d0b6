#include "engine/study/setting.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/read_scenario.h"

namespace netpocket {
namespace {

Diagnostics single(const std::string& key, std::string message) {
  Diagnostics diagnostics;
  diagnostics.add({.key = key, .message = std::move(message)});
  return diagnostics;
}

template <typename Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// "rods.profile[1][0]" is the parameter "rods.profile" with indices 1, 0. Without indices: the whole parameter.
struct KeyPlace {
  std::string parameter;
  std::vector<std::size_t> indices;
};

std::optional<KeyPlace> parse_place(const std::string& key) {
  const auto bracket = key.find('[');
  KeyPlace place{key.substr(0, bracket), {}};
  for (auto at = bracket; at < key.size();) {
    const auto close = key.find(']', at);
    if (key[at] != '[' || close == key.npos) return std::nullopt;
    const auto index = parse<std::size_t>(std::string_view(key).substr(at + 1, close - at - 1));
    if (!index) return std::nullopt;
    place.indices.push_back(*index);
    at = close + 1;
  }
  return place;
}

// The number at these indices of a list; null when there is none.
double* number_at(ParameterValue& value, const std::vector<std::size_t>& indices) {
  if (auto* vector = std::get_if<Eigen::Vector3d>(&value)) {
    return indices.size() == 1 && indices[0] < 3 ? &(*vector)[static_cast<Eigen::Index>(indices[0])] : nullptr;
  }
  if (auto* pairs = std::get_if<std::vector<Eigen::Vector2d>>(&value)) {
    const bool exists = indices.size() == 2 && indices[0] < pairs->size() && indices[1] < 2;
    return exists ? &(*pairs)[indices[0]][static_cast<Eigen::Index>(indices[1])] : nullptr;
  }
  return nullptr;
}

Diagnostics apply_to_number(Scenario& scenario, const Setting& setting, const KeyPlace& place) {
  const Parameter* parameter = find_parameter(place.parameter, scenario);
  if (!parameter) {
    const auto nearest = nearest_parameter_key(place.parameter, scenario.system);
    return single(setting.key, nearest ? fmt::format("is not a parameter; did you mean '{}'?", *nearest)
                                       : "is not a parameter; scenarios/REFERENCE.md lists them all");
  }
  ParameterValue value = parameter->get(scenario);
  double* number = number_at(value, place.indices);
  if (!number) {
    return single(setting.key, fmt::format("there is no such number in {} = {}; a vector has [0] to [2], a list of "
                                           "pairs [row][0] and [row][1]",
                                           parameter->key, toml_text(*parameter, parameter->get(scenario))));
  }
  const auto parsed = parse<double>(setting.value);
  if (!parsed || !std::isfinite(*parsed))
    return single(setting.key, "expects a number, not " + netpocket::quoted(setting.value));
  *number = *parsed;
  if (const auto problem = limit_problem(*parameter, value)) return single(setting.key, *problem);
  parameter->set(scenario, value);
  return {};
}

}  // namespace

Diagnostics apply_setting(Scenario& scenario, const Setting& setting) {
  const auto place = parse_place(setting.key);
  if (!place) {
    return single(setting.key, "is not a parameter nor a number of one, such as target.radius or rods.profile[1][0]");
  }
  if (!place->indices.empty()) return apply_to_number(scenario, setting, *place);
  const bool allows_absolute = scenario.files.allows_absolute;
  Diagnostics problems = apply_setting(scenario, setting.key + "=" + setting.value);
  scenario.files.allows_absolute = allows_absolute;  // only a command line may allow it, and a study is a file
  return problems;
}

std::optional<double> number_of(const Scenario& scenario, const std::string& key) {
  const auto place = parse_place(key);
  const Parameter* parameter = place ? find_parameter(place->parameter, scenario) : nullptr;
  if (!parameter) return std::nullopt;
  ParameterValue value = parameter->get(scenario);
  if (!place->indices.empty()) {
    const double* number = number_at(value, place->indices);
    return number ? std::optional(*number) : std::nullopt;
  }
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<std::int64_t>(&value)) return static_cast<double>(*number);
  return std::nullopt;
}

std::string value_of(const Scenario& scenario, const std::string& key) {
  if (key.find('[') != key.npos) return fmt::format("{}", number_of(scenario, key).value());
  const Parameter* parameter = find_parameter(key, scenario);
  return toml_text(*parameter, parameter->get(scenario));
}

Diagnostics apply_settings(Scenario& scenario, const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) {
    Diagnostics diagnostics = apply_setting(scenario, setting);
    if (!diagnostics.ok()) return diagnostics;
  }
  return {};
}

}  // namespace netpocket
