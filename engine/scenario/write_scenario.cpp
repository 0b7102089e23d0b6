#include "engine/scenario/write_scenario.h"

#include <fmt/format.h>

#include "engine/scenario/parameter_text.h"

namespace netpocket {
namespace {

std::string comment(const Parameter& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : fmt::format("[{}] ", parameter.unit);
  return fmt::format("# {}{} ({})", unit, parameter.help, parameter.source);
}

// "rate = 100   # [Hz] help (source)"
std::string line_of(const Parameter& parameter, const Scenario& scenario) {
  const std::string value = toml_text(parameter, parameter.get(scenario));
  return fmt::format("{:<32} {}\n", fmt::format("{} = {}", parameter.name(), value), comment(parameter));
}

}  // namespace

std::string write_scenario_text(const Scenario& scenario) {
  std::string text =
      "# A Netpocket scenario, complete: [unit] meaning (source); \"paper\" is Tang et al., Appl. Sci. 2023, 13, "
      "10377.\n\n";
  for (const ParameterGroup& group : parameter_groups(scenario.system)) {
    if (!group.name.empty()) text += fmt::format("\n[{}]\n", group.name);
    for (const Parameter& parameter : parameters_of(group, scenario.system)) {
      text += line_of(parameter, scenario);
    }
  }
  for (const ParameterList& list : parameter_lists(scenario.system)) {
    for (std::size_t item = 0; item < list.size(scenario); ++item) {
      text += fmt::format("\n[[{}]]\n", list.name);
      for (const Parameter& parameter : parameters_of(list, item)) text += line_of(parameter, scenario);
    }
  }
  return text;
}

}  // namespace netpocket
