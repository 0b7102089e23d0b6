#include "engine/scenario/scenario_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/scenario/parameters.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

struct ValueToJson {
  const Parameter& parameter;

  Json operator()(double value) const { return value; }
  Json operator()(std::int64_t value) const { return value; }
  Json operator()(bool value) const { return value; }
  Json operator()(const std::string& value) const { return value; }
  Json operator()(Choice value) const { return parameter.choices[static_cast<std::size_t>(value.index)]; }
  Json operator()(const Eigen::Vector3d& value) const { return {value.x(), value.y(), value.z()}; }
  Json operator()(const std::vector<Eigen::Vector2d>& values) const {
    Json rows = Json::array();
    for (const Eigen::Vector2d& row : values) rows.push_back({row.x(), row.y()});
    return rows;
  }
};

// "actuators.thruster" lies in "actuators".
Json& place_of(Json& root, std::string_view name) {
  std::string path(name);
  std::ranges::replace(path, '.', '/');
  return root[Json::json_pointer(path.empty() ? "" : "/" + path)];
}

void set_values(Json& table, std::span<const Parameter> parameters, const Scenario& scenario) {
  for (const Parameter& parameter : parameters) {
    table[std::string(parameter.name())] = std::visit(ValueToJson{parameter}, parameter.get(scenario));
  }
}

}  // namespace

Json scenario_json(const Scenario& scenario) {
  Json root = Json::object();
  for (const ParameterGroup& group : parameter_groups(scenario.system)) {
    set_values(place_of(root, group.name), parameters_of(group, scenario.system), scenario);
  }
  for (const ParameterList& list : parameter_lists(scenario.system)) {
    Json& items = place_of(root, list.name) = Json::array();
    for (std::size_t item = 0; item < list.size(scenario); ++item) {
      items.push_back(Json::object());
      set_values(items.back(), parameters_of(list, item), scenario);
    }
  }
  return root;
}

}  // namespace netpocket
