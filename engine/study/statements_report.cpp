#include "engine/study/statements_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/study/findings_report.h"
#include "engine/study/report_text.h"
#include "engine/study/study_table.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSeed = "solver.seed";

// The records of one point, one for each draw.
struct DrawnPoint {
  std::string name;
  std::vector<const StudyRecord*> draws;
};

// The point's place, and what the axes set.
std::string drawn_name(const Study& study, const StudyRecord& record) {
  std::vector<std::string> parts;
  if (const auto place = record["place"].get<std::string>(); !place.empty()) parts.push_back(place);
  for (const Axis& axis : study.axes) {
    if (axis.key != kSeed && record["settings"].contains(axis.key))
      parts.push_back(fmt::format("{} = {}", axis.key, record["settings"][axis.key].get<std::string>()));
  }
  return parts.empty() ? "all" : fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<DrawnPoint> drawn_points(const Study& study, const std::vector<StudyRecord>& records) {
  std::vector<DrawnPoint> points;
  std::vector<Json> settings;
  for (const StudyRecord& record : records) {
    Json own = record["settings"];
    own.erase(kSeed);
    own["place"] = record["place"];
    const auto known = std::ranges::find(settings, own);
    const auto index = static_cast<std::size_t>(known - settings.begin());
    if (known == settings.end()) {
      settings.push_back(own);
      points.push_back({drawn_name(study, record), {}});
    }
    points[index].draws.push_back(&record);
  }
  return points;
}

// NaN when the variant's run did not come to its end or has no such number.
double value_of_run(const StudyRecord& record, const std::string& variant, const std::string& column) {
  for (const Json& run : record["runs"]) {
    if (run["variant"] == variant && run["reason"] == "finished") return run_number(run, column);
  }
  return std::nan("");
}

std::vector<double> values_of(const DrawnPoint& point, const std::string& variant, const std::string& column) {
  std::vector<double> values;
  for (const StudyRecord* draw : point.draws) values.push_back(value_of_run(*draw, variant, column));
  return values;
}

// "1.2 to 3.4", the least and the largest of those that are known.
std::string range_text(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return "-";
  const auto [least, largest] = std::ranges::minmax(values);
  return least == largest ? fmt::format("{:.3g}", least) : fmt::format("{:.3g} to {:.3g}", least, largest);
}

struct JudgedPoint {
  std::vector<double> judged, against, numbers;  // by draw; `numbers` are those that the limits are for
  std::string verdict;
};

bool is_within(const StudyStatement& statement, double number) {
  return (!statement.at_most || number <= *statement.at_most) && (!statement.at_least || number >= *statement.at_least);
}

JudgedPoint judge(const StudyStatement& statement, const DrawnPoint& point) {
  JudgedPoint result{values_of(point, statement.variant, statement.column), {}, {}, {}};
  result.numbers = result.judged;
  if (!statement.against.empty()) {
    result.against = values_of(point, statement.against, statement.column);
    for (std::size_t i = 0; i < result.numbers.size(); ++i) result.numbers[i] /= result.against[i];
  }
  const auto holds = static_cast<std::size_t>(
      std::ranges::count_if(result.numbers, [&](double number) { return is_within(statement, number); }));
  if (std::ranges::any_of(result.numbers, [](double number) { return std::isnan(number); })) {
    result.verdict = "not known";
  } else if (holds == result.numbers.size()) {
    result.verdict = "yes";
  } else {
    result.verdict = holds == 0 ? "no" : fmt::format("undecided: in {} of {} draws", holds, result.numbers.size());
  }
  return result;
}

std::string verdict_of_all(const std::vector<JudgedPoint>& points) {
  const auto with = [&](const char* verdict) { return std::ranges::count(points, verdict, &JudgedPoint::verdict); };
  const auto yes = with("yes"), no = with("no");
  const char* verdict = yes == std::ssize(points) ? "yes" : no > 0 ? "no" : "undecided";
  return fmt::format("{}, holds at {} of {} points", verdict, yes, points.size());
}

std::string limits_text(const StudyStatement& statement) {
  std::vector<std::string> limits;
  if (statement.at_least) limits.push_back(fmt::format("at least {:g}", *statement.at_least));
  if (statement.at_most) limits.push_back(fmt::format("at most {:g}", *statement.at_most));
  return fmt::format("{}", fmt::join(limits, " and "));
}

class StatementsWriter {
 public:
  StatementsWriter(const Study& study, const std::vector<StudyRecord>& records)
      : study_(study), points_(drawn_points(study, records)) {
    for (const StudyRecord& record : records) {
      if (record["runs"].empty()) continue;
      std::vector<std::string> metrics;
      for (const auto& [name, value] : record["runs"][0]["metrics"].items()) metrics.push_back(name);
      columns_ = StudyTable(study, metrics, {}).columns();
      break;
    }
  }

  std::string text() const {
    std::string summary = markdown_header({"", "statement", "found"}), sections;
    for (std::size_t i = 0; i < study_.statements.size(); ++i) {
      const StudyStatement& statement = study_.statements[i];
      std::vector<JudgedPoint> judged;
      for (const DrawnPoint& point : points_) judged.push_back(judge(statement, point));
      const std::string id = fmt::format("S{}", i + 1);
      summary += fmt::format("| {} | {} | {} |\n", id, markdown_cell(statement.text), verdict_of_all(judged));
      sections += section(id, statement, judged);
    }
    return summary + "\n" + sections + shown_columns();
  }

 private:
  const TableColumn* column(const std::string& name) const {
    const auto found = std::ranges::find(columns_, name, &TableColumn::name);
    return found == columns_.end() ? nullptr : &*found;
  }

  std::string in_unit(const std::string& name) const {
    const TableColumn* known = column(name);
    return known && !known->unit.empty() && known->unit != "1" ? ", " + known->unit : "";
  }

  std::string rule(const StudyStatement& statement) const {
    const TableColumn* known = column(statement.column);
    std::string text = fmt::format("Rule: `{}`", statement.column);
    if (known && !known->meaning.empty()) text += fmt::format(" ({})", known->meaning);
    if (!statement.variant.empty()) text += fmt::format(" with {}", statement.variant);
    if (!statement.against.empty()) text += fmt::format(", divided by that with {},", statement.against);
    return text + fmt::format(" is {} in each draw.\n\n", limits_text(statement));
  }

  std::string section(const std::string& id, const StudyStatement& statement,
                      const std::vector<JudgedPoint>& judged) const {
    const bool is_ratio = !statement.against.empty();
    std::string text = fmt::format("### {} {}\n\n{}", id, statement.text, rule(statement));
    std::vector<std::string> header = {"point", "", statement.variant + in_unit(statement.column)};
    if (is_ratio) header.insert(header.end(), {statement.against + in_unit(statement.column), "ratio"});
    text += markdown_header(header);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      text += fmt::format("| {} | {} | {} |", markdown_cell(points_[i].name), judged[i].verdict,
                          range_text(judged[i].judged));
      if (is_ratio) text += fmt::format(" {} | {} |", range_text(judged[i].against), range_text(judged[i].numbers));
      text += "\n";
    }
    const auto remark = study_.remarks.find(id);
    return text + (remark != study_.remarks.end() ? fmt::format("\n{}\n\n", remark->second) : "\n");
  }

  std::string shown_columns() const {
    if (study_.report.show.empty()) return "";
    std::vector<std::string> header = {"point", "variant"};
    for (const std::string& name : study_.report.show) header.push_back(fmt::format("`{}`{}", name, in_unit(name)));
    std::string text = "### Values\n\n" + markdown_header(header);
    for (const DrawnPoint& point : points_) {
      for (const NamedSettings& variant : study_.variants) {
        text += fmt::format("| {} | {} |", markdown_cell(point.name), markdown_cell(variant.name));
        for (const std::string& name : study_.report.show)
          text += fmt::format(" {} |", range_text(values_of(point, variant.name, name)));
        text += "\n";
      }
    }
    return text + "\n";
  }

  const Study& study_;
  std::vector<DrawnPoint> points_;
  std::vector<TableColumn> columns_;
};

// What is missing from the numbers; empty: nothing.
std::string losses(const std::vector<StudyRecord>& records) {
  std::size_t refused = 0, diverged = 0, limited = 0;
  for (const StudyRecord& record : records) {
    refused += record["outcome"] == "refused" ? 1 : 0;
    diverged += record["outcome"] == "diverged" ? 1 : 0;
    limited += record["outcome"] == "limited" ? 1 : 0;
  }
  std::string text;
  if (refused > 0) text += fmt::format(" {} points were refused as not valid.", refused);
  if (diverged > 0) text += fmt::format(" {} points have runs that diverged.", diverged);
  if (limited > 0) text += fmt::format(" {} points have runs that reached their limit of steps.", limited);
  return text;
}

}  // namespace

std::string statements_report(const Study& study, const std::vector<StudyRecord>& records) {
  return fmt::format(
             "## {}\n\n{}\n\nWritten by `netpocket study {}.toml --report`; scenarios {}.{} Values with two "
             "ends are the least and the largest of the draws (`{}`).\n\n",
             study.name, study.description, study.file, study_identity(study), losses(records), kSeed) +
         StatementsWriter(study, records).text();
}

}  // namespace netpocket
