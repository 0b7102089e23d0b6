#include "engine/study/draft_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scenario/fidelity.h"

namespace netpocket {
namespace {

constexpr char kFidelityKey[] = "solver.fidelity";

bool names_fidelity(const std::vector<Setting>& settings) {
  return std::ranges::any_of(settings, [](const Setting& setting) { return setting.key == kFidelityKey; });
}

bool names_fidelity(const std::vector<NamedSettings>& all) {
  return std::ranges::any_of(all, [](const NamedSettings& named) { return names_fidelity(named.settings); });
}

// Whether runs may differ in their fidelity.
bool varies_fidelity(const Study& study) {
  const bool is_axis = std::ranges::any_of(study.axes, [](const Axis& axis) { return axis.key == kFidelityKey; });
  const bool is_drawn = std::ranges::any_of(study.uncertain, [](const UncertainInput& input) {
    return std::ranges::any_of(keys_of(input), [](const std::string& key) { return key == kFidelityKey; });
  });
  return is_axis || is_drawn || names_fidelity(study.places) || names_fidelity(study.variants);
}

}  // namespace

std::string draft_runs_text(const Study& study) {
  const bool varies = varies_fidelity(study);
  Scenario common = study.base;
  for (const Setting& setting : study.settings) {
    if (setting.key == kFidelityKey) (void)apply_setting(common, setting);
  }
  if (!varies && common.solver.fidelity == Fidelity::full) return "";
  const char* which = varies ? "runs with solver.fidelity = \"draft\"" : "all runs";
  return fmt::format("drafts: {}; {}\n", which, draft_notice(Fidelity::draft));
}

}  // namespace netpocket
