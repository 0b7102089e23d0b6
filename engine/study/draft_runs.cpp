#include "engine/study/draft_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scenario/fidelity.h"
#include "engine/study/record_files.h"

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

std::string drafts_text(bool all, const std::string& notice) {
  return fmt::format("drafts: {}; {}\n", all ? "all runs" : "runs with solver.fidelity = \"draft\"", notice);
}

}  // namespace

std::string draft_runs_text(const Study& study) {
  const bool varies = varies_fidelity(study);
  Scenario common = study.base;
  for (const Setting& setting : study.settings) {
    if (setting.key == kFidelityKey) (void)apply_setting(common, setting);
  }
  if (!varies && common.solver.fidelity == Fidelity::full) return "";
  return drafts_text(!varies, draft_notice(Fidelity::draft));
}

std::string recorded_drafts_text(const std::string& folder) {
  constexpr std::size_t kLookedAt = 100;  // records; where the fidelity varies, a draft is soon found
  std::vector<RecordPlace> places;
  scan_records(folder, [&](const RecordPlace& place) {
    if (places.size() < kLookedAt) places.push_back(place);
  });
  RecordReader reader;
  std::size_t runs = 0, drafts = 0;
  std::string notice;
  for (const RecordPlace& place : places) {
    const StudyRecord record = reader.read(place);
    for (const StudyRecord& run : record["runs"]) {
      ++runs;
      if (!run.contains("draft")) continue;
      ++drafts;
      notice = run["draft"].get<std::string>();
    }
  }
  return drafts == 0 ? "" : drafts_text(drafts == runs, notice);
}

}  // namespace netpocket
