#include "engine/study/study_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/analysis/metrics/metrics.h"
#include "engine/analysis/report.h"
#include "engine/base/whole_file.h"
#include "engine/study/study_hdf5.h"
#include "engine/study/study_plan.h"
#include "engine/systems/capture_system.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

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

struct SummaryColumn {
  const char* name;
  const char* pointer;  // JSON pointer into the summary
  const char* unit;
  const char* meaning;
};

constexpr SummaryColumn kSummary[] = {
    {"ended", "/reason", "", "finished, diverged or limited (solver.most_steps)"},
    {"captured", "/capture", "", "yes, no, or why it is not known"},
    {"first_contact_s", "/first_contact_time", "s", "first frame in which a cord touches the target"},
    {"peak_fx_N", "/peak_force/x", "N", "largest force on the target along x, with its sign"},
    {"peak_fy_N", "/peak_force/y", "N", "the same along y"},
    {"peak_fz_N", "/peak_force/z", "N", "the same along z"},
    {"peak_fy_time_s", "/peak_force/time_y", "s", "when the largest force along y acted"},
    {"impulse_x_Ns", "/impulse/x", "N s", "impulse of the contact forces on the target along x"},
    {"impulse_y_Ns", "/impulse/y", "N s", "the same along y"},
    {"impulse_z_Ns", "/impulse/z", "N s", "the same along z"},
    {"energy_error", "/energy_error", "1", "largest energy error by the energy put in"},
    {"averaging_window_s", "/averaging_window", "s", "over which recorded forces are means"},
    {"time_step_s", "/time_step", "s", "smallest step"},
};

// Keys of settings that not all points share, in the order in which points have them first.
std::vector<std::string> varied_keys(const Study& study) {
  const StudyPlan plan(study);
  const std::size_t groups = plan.group_count(), ensemble = static_cast<std::size_t>(study.ensemble.runs);
  std::vector<std::string> uncertain;
  for (const UncertainInput& input : study.uncertain) {
    for (std::string& key : keys_of(input)) uncertain.push_back(std::move(key));
  }
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < groups; ++i) indices.push_back(i);
  for (std::size_t i = plan.size() - ensemble; i < plan.size(); ++i) indices.push_back(i);
  std::vector<Setting> order;
  std::map<std::pair<std::string, std::string>, std::size_t> counts;
  for (const std::size_t i : indices) {
    for (const Setting& setting : plan.point(i).settings) {
      if (counts[{setting.key, setting.value}]++ == 0) order.push_back(setting);
    }
  }
  std::vector<std::string> keys;
  for (const Axis& axis : study.optimisation.over) keys.push_back(axis.key);
  for (const Setting& setting : order) {
    const bool is_shared = counts[{setting.key, setting.value}] == indices.size();
    const bool is_known = std::ranges::count(keys, setting.key) + std::ranges::count(uncertain, setting.key) > 0;
    if (!is_shared && !is_known) keys.push_back(setting.key);
  }
  return keys;
}

std::string unit_of(const Study& study, const std::string& key) {
  const Parameter* parameter = find_parameter(key.substr(0, key.find('[')), study.base);
  if (!parameter) return "";
  const bool is_number = parameter->type == ParameterType::number || parameter->type == ParameterType::integer ||
                         parameter->type == ParameterType::vector;
  return parameter->unit.empty() && is_number ? "1" : std::string(parameter->unit);
}

std::string help_of(const Study& study, const std::string& key) {
  const Parameter* parameter = find_parameter(key.substr(0, key.find('[')), study.base);
  return parameter ? std::string(parameter->help) : "";
}

// Units and meanings of metrics by name, as the structure of the first point has them.
std::map<std::string, Metric> known_metrics(const Study& study) {
  std::map<std::string, Metric> known;
  const StudyPlan plan(study);
  const std::size_t tries = std::min<std::size_t>(plan.size(), 100);
  for (std::size_t i = 0; i < tries && known.empty(); ++i) {
    const StudyScenario made = study_scenario(study, plan.point(i), study.variants.front());
    if (!made.diagnostics.ok()) continue;
    const Structure structure = build_capture_system(made.scenario).structure;
    for (const Metric& metric : MetricsCollector(structure, {}).metrics()) known.emplace(metric.name, metric);
  }
  return known;
}

TableColumn metric_column(const std::map<std::string, Metric>& known, const std::string& name) {
  const auto metric = known.find(name);
  if (metric != known.end()) return {name, metric->second.unit, metric->second.meaning};
  return {name, name.starts_with("load_") ? "N" : "", "on a part that the first point's target does not have"};
}

void add_new(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// Takes in the names of a record's metrics and findings.
void collect_names(const StudyRecord& record, std::vector<std::string>& metrics, std::vector<std::string>& findings) {
  for (const Json& run : record["runs"]) {
    if (!run.contains("metrics")) continue;
    for (const auto& [name, value] : run["metrics"].items()) add_new(metrics, name);
  }
  for (const Json& finding : record["findings"]) add_new(findings, finding["id"].get<std::string>());
}

Json rules() {
  Json rules = Json::object();
  for (const Finding& finding : evaluate_findings({})) rules[finding.id] = finding.rule;
  return rules;
}

std::string timing_rows(const StudyRecord& record) {
  std::string text;
  for (const Json& timing : record["timings"]) {
    text += csv_line({record["point"].dump(), csv_cell(timing["variant"]), timing["wall_seconds"].dump(),
                      timing["cpu_seconds"].dump()});
  }
  return text;
}

std::string columns_csv(const StudyTable& table) {
  std::string text = "name,unit,meaning\n";
  for (const TableColumn& column : table.columns()) {
    text += csv_line({csv_cell(column.name), csv_cell(column.unit), csv_cell(column.meaning)});
  }
  return text;
}

}  // namespace

StudyTable::StudyTable(const Study& study, std::vector<std::string> metrics, std::vector<std::string> findings)
    : settings_(varied_keys(study)),
      used_(used_keys(study)),
      metrics_(std::move(metrics)),
      findings_(std::move(findings)) {
  columns_ = {{"point", "1", "number of the point"},
              {"place", "", "name of its [[point]]"},
              {"draw", "1", "number of its draw of the ensemble; 0: not of it"}};
  for (const std::string& key : settings_) columns_.push_back({key, unit_of(study, key), help_of(study, key)});
  for (const std::string& key : used_) columns_.push_back({key, unit_of(study, key), help_of(study, key)});
  columns_.push_back({"variant", "", "name of the run's [[variant]]"});
  columns_.push_back({"refused", "", "why the point was not run"});
  for (const SummaryColumn& column : kSummary) columns_.push_back({column.name, column.unit, column.meaning});
  const auto known = metrics_.empty() ? std::map<std::string, Metric>() : known_metrics(study);
  for (const std::string& name : metrics_) columns_.push_back(metric_column(known, name));
  for (const std::string& id : findings_) {
    columns_.push_back({id, "", "whether the finding holds"});
    columns_.push_back({id + "_found", "", "what was found for it"});
  }
}

std::string StudyTable::header() const {
  std::vector<std::string> names;
  for (const TableColumn& column : columns_) names.push_back(csv_cell(column.name));
  return csv_line(names);
}

std::vector<std::string> StudyTable::first_cells(const StudyRecord& record) const {
  std::vector<std::string> cells = {record["point"].dump(), csv_cell(record["place"]), record["draw"].dump()};
  for (const std::string& key : settings_) {
    cells.push_back(record["settings"].contains(key) ? csv_cell(record["settings"][key]) : "");
  }
  return cells;
}

std::vector<std::string> StudyTable::row(const StudyRecord& record, std::size_t index) const {
  const Json& run = record["runs"][index];
  std::vector<std::string> cells = first_cells(record);
  for (const std::string& key : used_) cells.push_back(csv_cell(run["used"].value(key, Json())));
  cells.insert(cells.end(), {csv_cell(run["variant"]), ""});
  for (const SummaryColumn& column : kSummary) cells.push_back(csv_cell(run.at(Json::json_pointer(column.pointer))));
  for (const std::string& name : metrics_) cells.push_back(csv_cell(run["metrics"].value(name, Json())));
  for (const Json& finding : record["findings"]) {
    cells.push_back(csv_cell(finding["cases"][index]["verdict"]));
    cells.push_back(csv_cell(finding["cases"][index]["value"]));
  }
  return cells;
}

std::string StudyTable::rows(const StudyRecord& record) const {
  std::string text;
  for (std::size_t i = 0; i < record["runs"].size(); ++i) text += csv_line(row(record, i));
  if (!record["runs"].empty()) return text;
  std::vector<std::string> cells = first_cells(record);
  for (const std::string& key : used_) {
    const bool is_set = record["settings"].contains(key);
    cells.push_back(is_set ? csv_cell(record["settings"][key]) : "");
  }
  cells.insert(cells.end(), {"", csv_cell(record["refused"])});
  cells.resize(columns_.size());
  return csv_line(cells);
}

double run_number(const StudyRecord& run, const std::string& column) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto number = [](const Json& value) { return value.is_number() ? value.get<double>() : kNone; };
  if (column == "captured") {
    return run["captured"].is_boolean() ? static_cast<double>(run["captured"].get<bool>()) : kNone;
  }
  for (const SummaryColumn& known : kSummary) {
    if (column == known.name) return number(run.at(Json::json_pointer(known.pointer)));
  }
  for (const char* group : {"metrics", "used"}) {
    if (run.contains(group) && run[group].contains(column)) return number(run[group][column]);
  }
  return kNone;
}

std::string study_csv(const Study& study, const std::vector<StudyRecord>& records) {
  std::vector<std::string> metrics, findings;
  for (const StudyRecord& record : records) collect_names(record, metrics, findings);
  const StudyTable table(study, metrics, findings);
  std::string text = table.header();
  for (const StudyRecord& record : records) text += table.rows(record);
  return text;
}

void write_study_tables(const Study& study, const std::string& folder, const std::vector<RecordPlace>& places) {
  std::vector<std::string> metrics, findings;
  RecordReader reader;
  for (const RecordPlace& place : places) collect_names(reader.read(place), metrics, findings);
  const StudyTable table(study, metrics, findings);
  WholeFile csv(folder + "/study.csv", FileKind::csv), timings(folder + "/study_timings.csv", FileKind::csv);
  WholeFile json(folder + "/study.json", FileKind::json);
  csv.write(table.header());
  timings.write("point,variant,wall_s,cpu_s\n");
  json.write(fmt::format("{{\n \"study\": {},\n \"description\": {},\n \"rules\": {},\n \"points\": [",
                         Json(study.name).dump(), Json(study.description).dump(), rules().dump()));
  const char* separator = "\n  ";
  for (const RecordPlace& place : places) {
    StudyRecord record = reader.read(place);
    csv.write(table.rows(record));
    timings.write(timing_rows(record));
    record.erase("timings");
    json.write(separator + record.dump());
    separator = ",\n  ";
  }
  json.write("\n ]\n}\n");
  csv.commit();
  timings.commit();
  json.commit();
  write_whole_file(folder + "/study_columns.csv", FileKind::csv, columns_csv(table));
  write_study_hdf5(folder);
}

}  // namespace netpocket
