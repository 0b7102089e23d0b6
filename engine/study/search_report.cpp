#include "engine/study/search_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/study/findings_report.h"
#include "engine/study/report_text.h"
#include "engine/study/statements_report.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;
using Points = std::vector<const StudyRecord*>;

Points run_points(const std::vector<StudyRecord>& records) {
  Points points;
  for (const StudyRecord& record : records) {
    if (!record["runs"].empty()) points.push_back(&record);
  }
  return points;
}

// Merit of a point: number of findings that hold in all variants, then number of cases that hold.
std::pair<std::size_t, std::size_t> merit(const StudyRecord& record) {
  std::size_t cases = 0;
  for (const Json& finding : record["findings"]) {
    for (const Json& c : finding["cases"]) cases += c["holds"] == true ? 1 : 0;
  }
  return {held_findings(record).size(), cases};
}

Points best_points(Points points, std::size_t count) {
  if (count == 0) return points;
  std::stable_sort(points.begin(), points.end(),
                   [](const StudyRecord* a, const StudyRecord* b) { return merit(*a) > merit(*b); });
  points.resize(std::min(count, points.size()));
  return points;
}

// Settings that differ between points, in the order of the study.
std::vector<std::string> varied_settings(const std::vector<StudyRecord>& records) {
  std::vector<std::string> keys;
  for (const StudyRecord& record : records) {
    for (const auto& [key, value] : record["settings"].items()) {
      const auto same = [&name = key, &expected = value](const StudyRecord& other) {
        return other["settings"].contains(name) && other["settings"][name] == expected;
      };
      if (std::ranges::count(keys, key) == 0 && !std::ranges::all_of(records, same)) keys.push_back(key);
    }
  }
  return keys;
}

std::string counts_line(const Points& points, std::size_t all) {
  std::map<std::string, std::size_t> held;
  std::size_t diverged = 0;
  for (const StudyRecord* point : points) {
    for (const std::string& id : held_findings(*point)) ++held[id];
    const auto& runs = (*point)["runs"];
    const auto finished = [](const Json& run) { return run["reason"] == "finished"; };
    diverged += std::all_of(runs.begin(), runs.end(), finished) ? 0 : 1;
  }
  std::vector<std::string> counts;
  for (const Json& finding : (*points.front())["findings"]) {
    const std::string id = finding["id"].get<std::string>();
    counts.push_back(fmt::format("{} at {}", id, held[id]));
  }
  std::string text = fmt::format("{} points", all);
  if (all > points.size()) text += fmt::format(", {} of them refused as not valid", all - points.size());
  if (diverged > 0) text += fmt::format(", {} with runs that diverged or reached their limit of steps", diverged);
  return fmt::format("{}. In all cases hold {}.\n\n", text, fmt::join(counts, ", "));
}

std::string values_cell(const StudyRecord& point, const std::string& id) {
  const Json* finding = find_finding(point, id);
  if (!finding) return "";
  std::vector<std::string> values;
  for (const Json& c : (*finding)["cases"]) {
    values.push_back(fmt::format("{}: {}, {}", c["name"].get<std::string>(), c["verdict"].get<std::string>(),
                                 c["value"].get<std::string>()));
  }
  return markdown_cell(fmt::format("{}", fmt::join(values, "<br>")));
}

std::string points_table(const Study& study, const std::vector<StudyRecord>& records, const Points& points) {
  const std::vector<std::string> keys = varied_settings(records);
  std::vector<std::string> names = {"point"};
  for (const std::string& key : keys) names.push_back("`" + key + "`");
  names.emplace_back("findings that hold in all cases");
  names.insert(names.end(), study.report.show.begin(), study.report.show.end());
  std::string text = markdown_header(names);
  for (const StudyRecord* point : points) {
    text += fmt::format("| {} |", markdown_cell(point_name(*point)));
    const Json& settings = (*point)["settings"];
    for (const std::string& key : keys) {
      text += fmt::format(" {} |", settings.contains(key) ? markdown_cell(settings[key].get<std::string>()) : "");
    }
    const std::vector<std::string> held = held_findings(*point);
    text += fmt::format(" {}: {} |", held.size(), fmt::join(held, " "));
    for (const std::string& id : study.report.show) text += fmt::format(" {} |", values_cell(*point, id));
    text += "\n";
  }
  return text;
}

}  // namespace

std::string search_report(const Study& study, const std::vector<StudyRecord>& records) {
  std::string text = fmt::format("## {}\n\n{}\n\n", study.name, study.description);
  const Points points = run_points(records);
  if (points.empty()) return text + "No point was run.\n";
  text +=
      fmt::format("Written by `netpocket study {}.toml --report`; scenarios {}. ", study.file, study_identity(study));
  text += counts_line(points, records.size());
  text += points_table(study, records, best_points(points, static_cast<std::size_t>(study.report.best)));
  for (const auto& [finding, remark] : study.remarks) text += fmt::format("\n{}: {}\n", finding, remark);
  return text;
}

std::string study_report(const Study& study, const std::vector<StudyRecord>& records) {
  if (study.report.of == ReportOf::statements) return statements_report(study, records);
  return study.report.of == ReportOf::search ? search_report(study, records) : findings_report(study, records);
}

}  // namespace netpocket
