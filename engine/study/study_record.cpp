#include "engine/study/study_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analysis/report.h"
#include "engine/bodies/triangle_mesh.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/pocket_tether.h"
#include "engine/scenario/sector_scatter.h"
#include "engine/scenario/target_shape.h"
#include "engine/scenario/write_scenario.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

// FNV-1a, 64 bit.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xcbf29ce484222325u;
  for (const unsigned char c : text) value = (value ^ c) * 0x100000001b3u;
  return value;
}

void append(std::string& bytes, const void* values, std::size_t size) {
  bytes.append(static_cast<const char*>(values), size);
}

// The mesh data of a scenario. Its text only names the file.
std::string mesh_bytes(const Scenario& scenario) {
  if (scenario.target.shape != TargetShape::mesh) return {};
  const auto shape = target_shape(scenario);
  const auto* found = std::get_if<Shape>(&shape);
  if (!found) return {};
  const TriangleMesh& mesh = *std::get<MeshShape>(*found).mesh;
  std::string bytes;
  append(bytes, mesh.centre_in_file().data(), 3 * sizeof(double));
  for (const Eigen::Vector3d& vertex : mesh.vertices()) append(bytes, vertex.data(), 3 * sizeof(double));
  append(bytes, mesh.triangles().data(), mesh.triangles().size() * sizeof(Triangle));
  return bytes;
}

bool has_scatter(const Scenario& scenario) {
  for (const std::string_view key : {kRodStiffness, kRodPressure, kPanelStiffness}) {
    const Parameter* parameter = find_parameter(key, scenario);
    if (parameter == nullptr || parameter->get(scenario) != parameter->initial()) return true;
  }
  return false;
}

// Also if the table states anything although it does nothing: a pocket without a tether is the same.
bool has_pocket_tether(const Scenario& scenario) {
  return scenario.system != kPocketSystem || pocket_tether(scenario).attached;
}

// Erases what begins with `first` up to before the next `next`.
void erase_from(std::string& text, const std::string& first, const std::string& next) {
  const auto begin = text.find(first);
  if (begin == text.npos) return;
  const auto end = std::min(text.find(next, begin + 1), text.size());
  text.erase(begin, end - begin);
}

// Erases the line of a parameter that a table has.
void erase_key(std::string& text, std::string_view key) {
  const auto dot = key.rfind('.');
  const auto table = text.find(fmt::format("\n[{}]\n", key.substr(0, dot)));
  const auto begin = text.find(fmt::format("\n{} = ", key.substr(dot + 1)), table);
  if (table == text.npos || begin == text.npos) return;
  text.erase(begin, std::min(text.find('\n', begin + 1), text.size()) - begin);
}

ParameterValue default_of(const Parameter& parameter) {
  return parameter.initial != nullptr ? parameter.initial() : parameter.get(Scenario{});
}

// Parameters that came after the first studies and whose default changes nothing.
constexpr std::string_view kLater[] = {"contact.edge_radius",
                                       "solver.most_steps",
                                       "solver.fidelity",
                                       "solver.symmetry",
                                       "drawstring.passage",
                                       "drawstring.ring_friction",
                                       "drawstring.ring_angle",
                                       "drawstring.ring_spacing",
                                       "tether.winch",
                                       "tether.drive",
                                       "tether.rate",
                                       "tether.tension",
                                       "tether.drive_starts_at",
                                       "tether.drive_delay",
                                       "tether.slip_tension",
                                       "tether.brake_starts_at",
                                       "tether.brake_at",
                                       "tether.brake_delay",
                                       "tether.drum_radius",
                                       "tether.drum_inertia",
                                       "tether.motor_torque",
                                       "tether.fastest",
                                       "tether.reserve",
                                       "tether.least_length"};

// The complete scenario, but without [scatter] and later parameters where these do nothing: studies from before they
// came are the same as after.
std::string identified_text(const Scenario& scenario) {
  std::string text = write_scenario_text(scenario);
  if (!has_scatter(scenario)) erase_from(text, fmt::format("\n[{}]\n", scatter_group().name), "\n[");
  if (!has_pocket_tether(scenario)) erase_from(text, fmt::format("\n[{}]\n", pocket_tether_group().name), "\n[");
  for (const std::string_view key : kLater) {
    const Parameter* parameter = find_parameter(key, scenario);
    if (parameter == nullptr || parameter->get(scenario) != default_of(*parameter)) continue;
    erase_key(text, key);
  }
  if (!scenario.orbit.is_on()) erase_from(text, "\n[orbit]\n", "\n[");
  return text;
}

// Begins with what record_files.h looks for in a line.
StudyRecord head(std::size_t index, const char* outcome, const StudyPoint& point, const std::string& identity) {
  Json settings = Json::object();
  for (const Setting& setting : point.settings) settings[setting.key] = setting.value;
  return {{"point", index + 1},   {"outcome", outcome}, {"identity", identity},
          {"place", point.place}, {"draw", point.draw}, {"settings", settings}};
}

// A limited run beside one that diverged is the lesser evil.
const char* outcome_of(const std::vector<StudyRecord>& runs) {
  const auto ended = [&](RunReason reason) {
    return [reason](const StudyRecord& run) { return run["reason"] == to_string(reason); };
  };
  if (std::ranges::all_of(runs, ended(RunReason::finished))) return "done";
  const auto limited = std::ranges::count_if(runs, ended(RunReason::limited));
  const auto finished = std::ranges::count_if(runs, ended(RunReason::finished));
  return limited + finished == static_cast<std::ptrdiff_t>(runs.size()) ? "limited" : "diverged";
}

}  // namespace

std::string point_identity(const std::vector<Scenario>& scenarios, const std::string& program) {
  std::string all = program;
  for (const Scenario& scenario : scenarios) {
    all.append(1, '\n').append(identified_text(scenario)).append(mesh_bytes(scenario));
  }
  return fmt::format("{:016x}", hash(all));
}

StudyRecord refused_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                           const std::string& reason) {
  StudyRecord record = head(index, "refused", point, identity);
  record["refused"] = reason;
  record["runs"] = Json::array();
  record["findings"] = Json::array();
  record["timings"] = Json::array();
  return record;
}

StudyRecord run_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                       std::vector<StudyRecord> runs, const std::vector<Recording>& recordings) {
  StudyRecord record = head(index, outcome_of(runs), point, identity);
  record["refused"] = "";
  record["runs"] = Json::array();
  Json timings = Json::array();
  for (StudyRecord& run : runs) {
    timings.push_back(
        {{"variant", run["variant"]}, {"wall_seconds", run["wall_seconds"]}, {"cpu_seconds", run["cpu_seconds"]}});
    run.erase("wall_seconds");
    run.erase("cpu_seconds");
    record["runs"].push_back(std::move(run));
  }
  std::vector<const Recording*> judged;
  for (const Recording& recording : recordings) judged.push_back(&recording);
  record["findings"] = judged.empty() ? Json::array() : findings_json(evaluate_findings(judged))["findings"];
  record["timings"] = std::move(timings);
  return record;
}

std::vector<std::string> used_keys(const Study& study) {
  std::vector<std::string> used;
  for (const UncertainInput& input : study.uncertain) {
    for (const std::string& key : keys_of(input)) {
      const Parameter* parameter = find_parameter(key, study.base);
      const bool is_vector = parameter && parameter->type == ParameterType::vector;
      for (int i = 0; is_vector && i < 3; ++i) used.push_back(fmt::format("{}[{}]", key, i));
      if (!is_vector) used.push_back(key);
    }
  }
  return used;
}

}  // namespace netpocket
