#include "engine/scenario/reference.h"

#include <fmt/format.h>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/system_parameters.h"
#include "engine/scenario/thrown_net_parameters.h"

namespace netpocket {
namespace {

constexpr std::string_view kIntroduction = R"(# Parameters of a scenario

A scenario is a TOML file. Every key is optional; what is left out has the default below. SI units; the world's Y axis
is the pocket's axis and the mouth opens towards +Y. "paper" is Tang, Deng, Bai, Wei, Zhao: Dynamics Analysis of Space
Netted Pocket System Capturing Non-Cooperative Target, Appl. Sci. 2023, 13, 10377; where it is silent the value is an
assumption.

`system` names the kind of capture system. This page is about `pocket`, the netted pocket; its last part is about
`thrown_net`, the thrown net.

`target.mesh_file` may also be a PLY or a binary glTF (.glb) file.

This file is generated from the parameter table in engine/scenario/parameters.cpp. A test compares the two;
`NETPOCKET_RENEW=1 build/tests/test_scenario --gtest_filter='Reference.*'` writes it anew.
)";

std::string type_text(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::number:
      return "number";
    case ParameterType::integer:
      return "whole number";
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::text:
      return "text";
    case ParameterType::choice: {
      std::string names;
      for (const std::string_view name : parameter.choices)
        names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
      return names;
    }
    case ParameterType::vector:
      return "[x, y, z]";
    case ParameterType::pairs:
      return "list of pairs";
  }
  return {};
}

constexpr std::string_view kHead =
    "| key | type | default | unit | allowed | meaning | source |\n|---|---|---|---|---|---|---|\n";

constexpr std::string_view kLists = R"(
# Lists of tables

A scenario may have any number of the following tables, up to 32 of each. Settings and messages number them from 0:
`--set controller.0.rate=50`.
)";

constexpr std::string_view kThrownNet = R"(
# The thrown net

`system = "thrown_net"`: corner masses spread a thrown net that wraps the target; a drawstring closes it and a tether
tows. It is thrown along +Y from the spacecraft's +y face. It has the tables above without a name and `solver`, `output`,
{}, and these.
)";

std::string row(const Parameter& p, const Scenario& defaults) {
  return fmt::format("| `{}` | {} | `{}` | {} | {} | {} | {} |\n", p.name(), type_text(p),
                     toml_text(p, p.get(defaults)), p.unit, allowed_text(p), p.help, p.source);
}

std::string table_of(const ParameterGroup& group, std::string_view system, const Scenario& defaults) {
  const std::string table = group.name.empty() ? "" : fmt::format(" `[{}]`", group.name);
  std::string text = fmt::format("\n## {}{}\n\n{}\n\n{}", group.title, table, group.help, kHead);
  for (const Parameter& p : parameters_of(group, system)) text += row(p, defaults);
  return text;
}

std::string tables_of_thrown_net() {
  const SystemParameters& kind = thrown_net_system_parameters();
  Scenario defaults;
  defaults.system = kThrownNetSystem;
  std::string shared;
  for (const std::string_view name : kind.shared_groups) {
    shared += fmt::format("{}`{}`", shared.empty() ? "" : ", ", name);
  }
  std::string text = fmt::format(kThrownNet, shared);
  for (const ParameterGroup& group : kind.groups) text += table_of(group, kind.name, defaults);
  return text;
}

}  // namespace

std::string parameter_reference() {
  Scenario defaults;
  std::string text(kIntroduction);
  for (const ParameterGroup& group : parameter_groups()) text += table_of(group, kPocketSystem, defaults);
  text += kLists;
  for (const ParameterList& list : parameter_lists()) {
    list.resize(defaults, 1);
    text += fmt::format("\n## {} `[[{}]]`\n\n{}\n\n{}", list.title, list.name, list.help, kHead);
    for (const Parameter& p : parameters_of(list, 0)) text += row(p, defaults);
  }
  return text + tables_of_thrown_net();
}

}  // namespace netpocket
