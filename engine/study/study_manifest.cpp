#include "engine/study/study_manifest.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "engine/base/whole_file.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"
#include "engine/study/optimisation.h"
#include "engine/study/rare_failure.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

const char* sampling_name(Sampling sampling) {
  switch (sampling) {
    case Sampling::grid:
      return "grid";
    case Sampling::halton:
      return "halton";
    case Sampling::monte_carlo:
      return "monte_carlo";
    case Sampling::latin_hypercube:
      return "latin_hypercube";
    case Sampling::sobol:
      return "sobol";
  }
  return "";
}

Json settings_json(const std::vector<Setting>& settings) {
  Json list = Json::array();
  for (const Setting& setting : settings) list.push_back({setting.key, setting.value});
  return list;
}

Json variants_json(const std::vector<NamedSettings>& variants) {
  Json list = Json::array();
  for (const NamedSettings& variant : variants) {
    list.push_back({{"name", variant.name}, {"settings", settings_json(variant.settings)}});
  }
  return list;
}

std::vector<NamedSettings> variants_from(const Json& list) {
  std::vector<NamedSettings> variants;
  for (const Json& entry : list) {
    NamedSettings& variant = variants.emplace_back();
    if (entry.is_string()) {  // of an earlier version
      variant.name = entry.get<std::string>();
      continue;
    }
    variant.name = entry.at("name").get<std::string>();
    for (const Json& setting : entry.at("settings")) {
      variant.settings.push_back({setting.at(0).get<std::string>(), setting.at(1).get<std::string>()});
    }
  }
  return variants;
}

Scenario base_from(const Json& json, const std::string& path) {
  ScenarioResult base = read_scenario_text(json.at("text").get<std::string>(), path);
  if (!base.ok()) throw FileError(fmt::format("\"{}\" holds a damaged scenario: {}", path, base.diagnostics.text()));
  base.scenario.files.folder = json.at("folder").get<std::string>();
  return std::move(base.scenario);
}

}  // namespace

void write_study_manifest(const Study& study, std::size_t points, const std::string& folder,
                          const std::string& program) {
  const std::string file = study.path.empty() ? "" : std::filesystem::absolute(study.path).lexically_normal().string();
  Json manifest = {{"study", study.name},
                   {"file", file},
                   {"points", points},
                   {"variants", variants_json(study.variants)},
                   {"sampling", sampling_name(study.sampling)},
                   {"samples", study.samples},
                   {"seed", study.seed},
                   {"uncertain", used_keys(study)},
                   {"program", program},
                   {"scenario", point_identity({study.base}, program)},
                   {"base", {{"folder", study.base.files.folder}, {"text", write_scenario_text(study.base)}}}};
  if (study.optimisation.candidates > 0) manifest["objective"] = objective_name(study.optimisation);
  if (!study.rare.of.empty()) manifest["failure"] = failure_name(study.rare);
  write_whole_file(folder + "/" + kStudyManifest, FileKind::json, manifest.dump(1) + "\n");
}

StudyManifest read_study_manifest(const std::string& folder) {
  const std::string path = folder + "/" + kStudyManifest;
  std::ifstream file(path);
  if (!file) throw FileError(fmt::format("\"{}\" holds no study: there is no {} in it", folder, kStudyManifest));
  const Json json = Json::parse(file, nullptr, false);
  StudyManifest manifest;
  try {
    manifest.study = json.at("study").get<std::string>();
    manifest.points = json.at("points").get<std::size_t>();
    manifest.file = json.value("file", "");
    manifest.program = json.value("program", "");
    manifest.objective = json.value("objective", "");
    manifest.failure = json.value("failure", "");
    if (json.contains("uncertain")) manifest.uncertain = json.at("uncertain").get<std::vector<std::string>>();
    if (json.contains("variants")) manifest.variants = variants_from(json.at("variants"));
    if (json.contains("base")) manifest.base = base_from(json.at("base"), path);
  } catch (const Json::exception&) {
    throw FileError(fmt::format("\"{}\" is damaged", path));
  }
  return manifest;
}

StudyScenario recorded_scenario(const StudyManifest& manifest, const StudyRecord& record, std::size_t run) {
  StudyScenario none;
  const auto refuse = [&none](const std::string& message) {
    none.diagnostics.add({.message = message});
    return none;
  };
  if (!manifest.base) {
    return refuse(
        fmt::format("an earlier version made the folder of {}: go on with the study once (--resume), so that "
                    "the folder says what its scenario is",
                    manifest.study));
  }
  if (run >= manifest.variants.size()) return refuse("the study has no such variant");
  Study study;
  study.base = *manifest.base;
  StudyPoint point;
  for (const auto& [key, value] : record["settings"].items()) {
    point.settings.push_back({key, value.get<std::string>()});
  }
  return study_scenario(study, point, manifest.variants[run]);
}

bool is_as_recorded(const StudyManifest& manifest, const StudyRecord& record, const std::string& program) {
  std::vector<Scenario> scenarios;
  for (std::size_t run = 0; run < manifest.variants.size(); ++run) {
    StudyScenario made = recorded_scenario(manifest, record, run);
    if (!made.diagnostics.ok()) return false;
    scenarios.push_back(std::move(made.scenario));
  }
  return point_identity(scenarios, program) == record["identity"];
}

}  // namespace netpocket
