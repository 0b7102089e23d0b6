#include "engine/study/findings_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "engine/study/ensemble_report.h"
#include "engine/study/report_text.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

std::string verdict(const Json& finding_case) { return finding_case["verdict"].get<std::string>(); }

// Number of points after the first at which a finding holds in all variants.
struct Robustness {
  std::size_t holds = 0;
  std::size_t points = 0;     // that judge the finding
  std::size_t undecided = 0;  // that do not judge it, because they are single draws
  std::vector<std::string> fails;
};

bool is_undecided(const Json& finding) {
  return std::ranges::all_of(finding["cases"], [](const Json& c) { return c["verdict"] == "undecided"; });
}

Robustness robustness(const std::vector<StudyRecord>& records, const std::string& id) {
  Robustness result;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const Json* finding = find_finding(records[i], id);
    if (!finding) continue;
    if (is_undecided(*finding)) {
      ++result.undecided;
      continue;
    }
    ++result.points;
    if (holds_in_all_cases(*finding)) {
      ++result.holds;
      continue;
    }
    std::vector<std::string> cases;
    for (const Json& c : (*finding)["cases"]) {
      if (c["holds"] != true) cases.push_back(c["name"].get<std::string>());
    }
    result.fails.push_back(fmt::format("{} ({})", point_name(records[i]), fmt::join(cases, ", ")));
  }
  return result;
}

std::string robustness_cell(const Robustness& r) {
  if (r.points == 0) return r.undecided > 0 ? "single draws" : "";
  return fmt::format("{} of {} other points", r.holds, r.points);
}

std::string summary_table(const std::vector<StudyRecord>& records, const Ensemble& ensemble) {
  const StudyRecord& first = records.front();
  std::vector<std::string> names = {"", "the paper's statement"};
  for (const Json& run : first["runs"]) names.push_back(run["variant"].get<std::string>());
  if (ensemble.size() > 0) names.emplace_back("draws");
  if (records.size() > 1) names.emplace_back("also at");
  std::string text = markdown_header(names);
  for (const Json& finding : first["findings"]) {
    const std::string id = finding["id"].get<std::string>();
    text += fmt::format("| {} | {} |", id, markdown_cell(finding["text"].get<std::string>()));
    for (const Json& c : finding["cases"]) text += fmt::format(" {} |", verdict(c));
    if (ensemble.size() > 0) text += fmt::format(" {} |", ensemble.count_text(id));
    if (records.size() > 1) text += fmt::format(" {} |", robustness_cell(robustness(records, id)));
    text += "\n";
  }
  return text;
}

std::string finding_section(const Study& study, const std::vector<StudyRecord>& records, const Ensemble& ensemble,
                            const Json& finding) {
  const std::string id = finding["id"].get<std::string>();
  std::string text = fmt::format("### {} {}\n\nRule: {}.\n\n", id, finding["text"].get<std::string>(),
                                 finding["rule"].get<std::string>());
  text += markdown_header({"case", "", "found"});
  for (const Json& c : finding["cases"]) {
    text += fmt::format("| {} | {} | {} |\n", markdown_cell(c["name"].get<std::string>()), verdict(c),
                        markdown_cell(c["value"].get<std::string>()));
  }
  if (finding.contains("draws")) text += fmt::format("\nDraws: {}.\n", finding["draws"].get<std::string>());
  text += ensemble.section(id);
  const Robustness r = robustness(records, id);
  if (r.undecided > 0) text += fmt::format("\nNot decided at {} of the other points: one draw each.\n", r.undecided);
  if (r.points > 0) {
    text += fmt::format("\nHolds in all cases at {} of the {} other points", r.holds, r.points);
    text += r.fails.empty() ? ".\n" : fmt::format("; not at {}.\n", fmt::join(r.fails, "; "));
  }
  if (const auto remark = study.remarks.find(id); remark != study.remarks.end())
    text += fmt::format("\n{}\n", remark->second);
  return text + "\n";
}

std::string points_table(const std::vector<StudyRecord>& records) {
  const Json& runs = records.front()["runs"];
  std::vector<std::string> names = {"point", "changed"};
  for (const Json& run : runs) {
    const auto variant = run["variant"].get<std::string>();
    names.push_back(variant + " peak F_y, N");
    names.push_back(variant + " first contact, s");
  }
  names.emplace_back("findings that hold in all cases");
  std::string text = markdown_header(names);
  for (const StudyRecord& record : records) {
    text += fmt::format("| {} | {} |", markdown_cell(point_name(record)), markdown_cell(settings_text(record)));
    if (record["runs"].empty()) {
      text += fmt::format(" refused: {} |\n", markdown_cell(record["refused"].get<std::string>()));
      continue;
    }
    for (const Json& run : record["runs"]) {
      const Json& contact = run["first_contact_time"];
      text += fmt::format(" {:.4g} | {} |", run["peak_force"]["y"].get<double>(),
                          contact.is_null() ? "none" : fmt::format("{:.4g}", contact.get<double>()));
    }
    const std::vector<std::string> held = held_findings(record);
    text += fmt::format(" {}: {} |\n", held.size(), fmt::join(held, " "));
  }
  return text;
}

}  // namespace

std::string study_identity(const Study& study) {
  std::vector<Scenario> scenarios;
  for (const StudyPoint& point : study_points(study)) {
    for (const NamedSettings& variant : study.variants) {
      scenarios.push_back(study_scenario(study, point, variant).scenario);
    }
  }
  return point_identity(scenarios, "");
}

std::string findings_report(const Study& study, const std::vector<StudyRecord>& all) {
  const Ensemble ensemble(all);
  std::vector<StudyRecord> records;
  std::ranges::copy_if(all, std::back_inserter(records), [](const StudyRecord& r) { return r["draw"] == 0; });
  const auto was_run = [](const StudyRecord& record) { return !record["runs"].empty(); };
  if (records.empty() || !was_run(records.front()))
    return fmt::format("# {}\n\nThe first point was not run.\n", study.name);
  std::string text = "# Findings of the paper\n\n";
  text += study.description + "\n\n";
  text += fmt::format("Written by `netpocket study {}.toml --report`; scenarios {}.\n\n", study.file,
                      study_identity(study));
  ensemble.decide(records.front());
  text += summary_table(records, ensemble);
  text += "\n## One by one\n\n";
  for (const Json& finding : records.front()["findings"]) text += finding_section(study, records, ensemble, finding);
  text += "## Points\n\n";
  text += points_table(records);
  return text;
}

}  // namespace netpocket
