#include "engine/study/ensemble_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/analysis/paper/draws.h"
#include "engine/study/report_text.h"

namespace netpocket {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDecidedByDraws = "F3";

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

// Peaks |F_y| of all draws, by the end of closing (s).
std::vector<Draws> peaks_by_closing(const std::vector<StudyRecord>& draws) {
  std::map<double, std::vector<double>> peaks;
  for (const StudyRecord& draw : draws) {
    for (const Json& run : draw["runs"]) {
      peaks[run["closing_end"].get<double>()].push_back(std::abs(run["peak_force"]["y"].get<double>()));
    }
  }
  std::vector<Draws> groups;
  for (auto& [closing_end, values] : peaks) groups.push_back({closing_end, std::move(values)});
  return groups;
}

}  // namespace

Ensemble::Ensemble(const std::vector<StudyRecord>& records) {
  for (const StudyRecord& record : records) {
    if (record["draw"] == 0) continue;
    const auto finished = [](const Json& run) { return run["reason"] == "finished"; };
    if (record["runs"].empty() || !std::ranges::all_of(record["runs"], finished)) {
      ++lost_;
    } else {
      draws_.push_back(record);
    }
  }
}

void Ensemble::decide(StudyRecord& record) const {
  if (draws_.empty()) return;
  const std::vector<Draws> groups = peaks_by_closing(draws_);
  if (groups.size() < 2) return;
  const OrderOfDraws order = order_of_draws(groups, "N");
  for (Json& finding : record["findings"]) {
    if (finding["id"] != kDecidedByDraws) continue;
    for (std::size_t i = 0; i < finding["cases"].size(); ++i) {
      Json& c = finding["cases"][i];
      // Cases that diverged or ended early keep their verdict.
      if (c["verdict"] != to_string(Verdict::undecided)) continue;
      c["value"] = fmt::format("peak |F_y| {:.3g} N in the run without displacements",
                               std::abs(record["runs"][i]["peak_force"]["y"].get<double>()));
      c["verdict"] = to_string(order.verdict);
      c["holds"] = order.verdict == Verdict::yes ? Json(true) : order.verdict == Verdict::no ? Json(false) : Json();
    }
    finding["draws"] = order.text;
  }
}

std::string Ensemble::count_text(const std::string& id) const {
  if (id == kDecidedByDraws) return fmt::format("decided by {}", draws_.size());
  const auto holds = [&](const StudyRecord& draw) {
    const Json* finding = find_finding(draw, id);
    return finding && holds_in_all_cases(*finding);
  };
  return fmt::format("{} of {}", std::ranges::count_if(draws_, holds), draws_.size());
}

std::string Ensemble::section(const std::string& id) const {
  if (draws_.empty()) return "";
  std::string text = id == kDecidedByDraws
                         ? fmt::format("\nDecided by {} draws.", draws_.size())
                         : fmt::format("\nHolds in all cases in {} draws of the ensemble.", count_text(id));
  if (lost_ > 0) text += fmt::format(" {} more draws diverged or could not be run.", lost_);
  text += "\n";
  const Json* first = find_finding(draws_.front(), id);
  if (!first) return text;
  std::string rows;
  for (std::size_t c = 0; c < (*first)["cases"].size(); ++c) {
    std::map<std::string, std::vector<double>> values;  // by measure
    std::vector<std::string> order;
    std::size_t holding = 0;
    for (const StudyRecord& draw : draws_) {
      const Json& found = (*find_finding(draw, id))["cases"][c];
      holding += found["holds"] == true ? 1 : 0;
      for (const Json& m : found["measures"]) {
        const std::string name = fmt::format("{}, {}", m["name"].get<std::string>(), m["unit"].get<std::string>());
        if (!values.contains(name)) order.push_back(name);
        values[name].push_back(m["value"].get<double>());
      }
    }
    const std::string holds = id == kDecidedByDraws ? "" : fmt::format("{} of {}", holding, draws_.size());
    for (const std::string& name : order) {
      const std::vector<double>& v = values[name];
      const auto [least, most] = std::ranges::minmax_element(v);
      rows += fmt::format("| {} | {} | {} | {:.3g} | {:.3g} | {:.3g} |\n",
                          markdown_cell((*first)["cases"][c]["name"].get<std::string>()), holds, markdown_cell(name),
                          median(v), *least, *most);
    }
  }
  if (rows.empty()) return text;
  return text + "\n" + markdown_header({"case", "holds in draws", "number", "median", "least", "largest"}) + rows;
}

}  // namespace netpocket
