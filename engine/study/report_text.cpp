#include "engine/study/report_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace netpocket {

std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string markdown_header(const std::vector<std::string>& names) {
  std::string rule;
  for (std::size_t i = 0; i < names.size(); ++i) rule += "|---";
  return fmt::format("| {} |\n{}|\n", fmt::join(names, " | "), rule);
}

const StudyRecord* find_finding(const StudyRecord& record, const std::string& id) {
  for (const StudyRecord& finding : record["findings"]) {
    if (finding["id"] == id) return &finding;
  }
  return nullptr;
}

bool holds_in_all_cases(const StudyRecord& finding) {
  const auto& cases = finding["cases"];
  return std::all_of(cases.begin(), cases.end(), [](const StudyRecord& c) { return c["holds"] == true; });
}

std::vector<std::string> held_findings(const StudyRecord& record) {
  std::vector<std::string> held;
  for (const StudyRecord& finding : record["findings"]) {
    if (holds_in_all_cases(finding)) held.push_back(finding["id"].get<std::string>());
  }
  return held;
}

std::string point_name(const StudyRecord& record) {
  const std::string place = record["place"].get<std::string>();
  return place.empty() ? fmt::format("point {}", record["point"].get<int>()) : place;
}

std::string settings_text(const StudyRecord& record) {
  std::vector<std::string> parts;
  for (const auto& [key, value] : record["settings"].items()) {
    parts.push_back(fmt::format("`{} = {}`", key, value.get<std::string>()));
  }
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace netpocket
