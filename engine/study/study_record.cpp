#include "engine/study/study_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "engine/analysis/report.h"
#include "engine/bodies/triangle_mesh.h"
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

StudyRecord head(std::size_t index, const StudyPoint& point, const std::string& identity) {
  Json settings = Json::object();
  for (const Setting& setting : point.settings) settings[setting.key] = setting.value;
  return {{"point", index + 1},
          {"place", point.place},
          {"draw", point.draw},
          {"settings", settings},
          {"identity", identity}};
}

// Follows RFC 4180, except that each row is one line: line ends in a text are escaped as in TOML.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == text.npos) return text;
  std::string cell(1, '"');
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      cell += c == '\n' ? "\\n" : "\\r";
    } else {
      cell.append(c == '"' ? 2 : 1, c);
    }
  }
  cell += '"';
  return cell;
}

std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return csv_cell(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  return value.dump();
}

std::string csv_line(const std::vector<std::string>& cells) { return fmt::format("{}\n", fmt::join(cells, ",")); }

// Keys of settings that not all points share.
std::vector<std::string> varied_keys(const std::vector<StudyPoint>& points) {
  std::vector<std::string> keys;
  for (const StudyPoint& point : points) {
    for (const Setting& setting : point.settings) {
      const auto differs = [&](const StudyPoint& other) { return !std::ranges::count(other.settings, setting); };
      if (std::ranges::count(keys, setting.key) > 0) continue;
      if (std::ranges::any_of(points, differs)) keys.push_back(setting.key);
    }
  }
  return keys;
}

struct Column {
  const char* name;
  const char* pointer;  // JSON pointer into the summary
};

constexpr Column kColumns[] = {
    {"ended", "/reason"},
    {"captured", "/capture"},
    {"first_contact_s", "/first_contact_time"},
    {"peak_fx_N", "/peak_force/x"},
    {"peak_fy_N", "/peak_force/y"},
    {"peak_fz_N", "/peak_force/z"},
    {"peak_fy_time_s", "/peak_force/time_y"},
    {"impulse_x_Ns", "/impulse/x"},
    {"impulse_y_Ns", "/impulse/y"},
    {"impulse_z_Ns", "/impulse/z"},
    {"energy_error", "/energy_error"},
    {"averaging_window_s", "/averaging_window"},
    {"time_step_s", "/time_step"},
    {"cpu_s", "/cpu_seconds"},
};

std::vector<std::string> finding_ids(const std::vector<StudyRecord>& records) {
  std::vector<std::string> ids;
  for (const StudyRecord& record : records) {
    if (!ids.empty()) break;
    for (const Json& finding : record["findings"]) ids.push_back(finding["id"].get<std::string>());
  }
  return ids;
}

std::vector<std::string> first_cells(const StudyRecord& record, const std::vector<std::string>& keys) {
  std::vector<std::string> cells = {record["point"].dump(), csv_cell(record["place"]), record["draw"].dump()};
  for (const std::string& key : keys) {
    cells.push_back(record["settings"].contains(key) ? csv_cell(record["settings"][key]) : "");
  }
  return cells;
}

}  // namespace

std::string point_identity(const std::vector<Scenario>& scenarios, const std::string& program) {
  std::string all = program;
  for (const Scenario& scenario : scenarios) {
    all.append(1, '\n').append(write_scenario_text(scenario)).append(mesh_bytes(scenario));
  }
  return fmt::format("{:016x}", hash(all));
}

StudyRecord refused_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                           const std::string& reason) {
  StudyRecord record = head(index, point, identity);
  record["refused"] = reason;
  record["runs"] = Json::array();
  record["findings"] = Json::array();
  return record;
}

StudyRecord run_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                       const std::vector<NamedSettings>& variants, const std::vector<Recording>& recordings) {
  StudyRecord record = head(index, point, identity);
  record["refused"] = "";
  record["runs"] = Json::array();
  std::vector<const Recording*> runs;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    Json run = {{"variant", variants[i].name}};
    run.update(summary_json(recordings[i]));
    record["runs"].push_back(std::move(run));
    runs.push_back(&recordings[i]);
  }
  record["findings"] = findings_json(evaluate_findings(runs))["findings"];
  return record;
}

std::string record_path(const std::string& folder, std::size_t index) {
  return fmt::format("{}/points/{:04}.json", folder, index + 1);
}

std::optional<StudyRecord> load_record(const std::string& path, const std::string& identity) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  StudyRecord record = StudyRecord::parse(file, nullptr, false);
  const bool usable = record.is_object() && record.value("identity", "") == identity;
  return usable ? std::optional(std::move(record)) : std::nullopt;
}

std::string study_csv(const Study& study, const std::vector<StudyRecord>& records) {
  const auto keys = varied_keys(study_points(study));
  const auto ids = finding_ids(records);
  std::vector<std::string> header = {"point", "place", "draw"};
  for (const std::string& key : keys) header.push_back(csv_cell(key));
  header.insert(header.end(), {"variant", "refused"});
  for (const Column& column : kColumns) header.emplace_back(column.name);
  for (const std::string& id : ids) header.insert(header.end(), {id, id + "_found"});
  std::string text = csv_line(header);
  for (const StudyRecord& record : records) {
    if (record["runs"].empty()) {
      auto cells = first_cells(record, keys);
      cells.insert(cells.end(), {"", csv_cell(record["refused"])});
      cells.resize(header.size());
      text += csv_line(cells);
    }
    for (std::size_t i = 0; i < record["runs"].size(); ++i) {
      const Json& run = record["runs"][i];
      auto cells = first_cells(record, keys);
      cells.insert(cells.end(), {csv_cell(run["variant"]), ""});
      for (const Column& column : kColumns) cells.push_back(csv_cell(run.at(Json::json_pointer(column.pointer))));
      for (const Json& finding : record["findings"]) {
        cells.push_back(csv_cell(finding["cases"][i]["verdict"]));
        cells.push_back(csv_cell(finding["cases"][i]["value"]));
      }
      text += csv_line(cells);
    }
  }
  return text;
}

Json study_json(const Study& study, const std::vector<StudyRecord>& records) {
  Json rules = Json::object();
  for (const Finding& finding : evaluate_findings({})) rules[finding.id] = finding.rule;
  return {{"study", study.name}, {"description", study.description}, {"rules", rules}, {"points", records}};
}

}  // namespace netpocket
