// Results of a search as tables and texts.
#include <fmt/format.h>

#include <cmath>

#include "engine/study/estimate.h"
#include "engine/study/optimisation.h"
#include "engine/study/report_text.h"

namespace netpocket {
namespace {

std::string number_cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

// "mean of peak_fy_N", "captured", "95 % quantile of closing_tension_peak".
std::string name_of(const ColumnOverDraws& of) {
  if (!of.fraction) return of.column == "captured" ? "probability of capture" : fmt::format("mean of {}", of.column);
  if (*of.fraction == 0) return fmt::format("least {}", of.column);
  if (*of.fraction == 1) return fmt::format("largest {}", of.column);
  return fmt::format("{:g} % quantile of {}", 100 * *of.fraction, of.column);
}

std::string limits_of(const StudyConstraint& constraint) {
  std::string text;
  if (constraint.at_least) text += fmt::format("at least {:g}", *constraint.at_least);
  if (constraint.at_most) text += fmt::format("{}at most {:g}", text.empty() ? "" : ", ", *constraint.at_most);
  return text;
}

// Objective, then constraints.
std::vector<std::string> quantity_names(const StudyOptimisation& search) {
  std::vector<std::string> names = {name_of(search.objective)};
  for (const StudyConstraint& constraint : search.constraints) names.push_back(name_of(constraint.value));
  return names;
}

std::vector<std::string> wishes(const StudyOptimisation& search) {
  std::vector<std::string> list = {search.is_maximised ? "largest" : "least"};
  for (const StudyConstraint& constraint : search.constraints) list.push_back(limits_of(constraint));
  return list;
}

std::string estimate_text(const EstimatedValue& estimate) {
  return fmt::format("{:.4g} ({})", estimate.value, interval_text(estimate.interval));
}

double quantity(const Candidate& candidate, std::size_t index) {
  return index == 0 ? candidate.objective : candidate.constraints[index - 1];
}

std::string change_text(double before, double after) {
  if (!(std::abs(before) > 0) || !std::isfinite(before) || !std::isfinite(after)) return "";
  return fmt::format("{:+.1f} %", 100 * (after - before) / std::abs(before));
}

}  // namespace

std::string objective_name(const StudyOptimisation& search) { return name_of(search.objective); }

std::string optimisation_csv(const Study& study, const Optimisation& result) {
  const StudyOptimisation& search = study.optimisation;
  std::string text = "candidate,generation";
  for (const Axis& axis : search.over) text += fmt::format(",{}", axis.key);
  text += ",objective";
  for (std::size_t i = 0; i < search.constraints.size(); ++i) text += fmt::format(",constraint_{}", i + 1);
  text += ",violation,is_feasible,best_so_far\n";
  const double sign = search.is_maximised ? -1 : 1;
  double best = INFINITY;
  for (std::size_t c = 0; c < result.candidates.size(); ++c) {
    const Candidate& candidate = result.candidates[c];
    text += fmt::format("{},{}", c, candidate.generation);
    for (const Setting& setting : candidate.settings) text += fmt::format(",{}", setting.value);
    text += fmt::format(",{}", number_cell(candidate.objective));
    for (const double value : candidate.constraints) text += fmt::format(",{}", number_cell(value));
    if (candidate.is_feasible()) best = std::min(best, sign * candidate.objective);
    text += fmt::format(",{},{},{}\n", number_cell(candidate.violation), candidate.is_feasible() ? "yes" : "no",
                        number_cell(sign * best));
  }
  return text;
}

std::string optimisation_text(const Study& study, const Optimisation& result) {
  const StudyOptimisation& search = study.optimisation;
  const Candidate &base = result.candidates.front(), &best = result.candidates[result.best];
  std::string text = fmt::format("best of {} candidates in {} generations, {} restarts:\n", result.candidates.size(),
                                 result.candidates.back().generation, result.restarts);
  if (!best.is_feasible()) text += "no candidate meets the constraints; this one comes nearest\n";
  for (std::size_t i = 0; i < best.settings.size(); ++i) {
    text += fmt::format("  {} = {} (base: {})\n", best.settings[i].key, best.settings[i].value, base.settings[i].value);
  }
  const auto names = quantity_names(search), wanted = wishes(search);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("  {} ({}): {:.4g}, base {:.4g}\n", names[i], wanted[i], quantity(best, i), quantity(base, i));
    if (result.after.empty()) continue;
    text += fmt::format("    with {} fresh draws: {}, base {}\n", search.check, estimate_text(result.after[i]),
                        estimate_text(result.before[i]));
  }
  return text;
}

std::string optimisation_report(const Study& study, const Optimisation& result) {
  const StudyOptimisation& search = study.optimisation;
  const Candidate &base = result.candidates.front(), &best = result.candidates[result.best];
  std::string text = fmt::format("# {}\n\n{}.\n\n", study.name, study.description);
  text += fmt::format("CMA-ES: {} candidates in {} generations, {} restarts", result.candidates.size(),
                      result.candidates.back().generation, result.restarts);
  if (!study.uncertain.empty()) text += fmt::format(", each with the same {} draws", study.samples);
  text += best.is_feasible() ? ".\n\n" : ". No candidate meets the constraints; this one comes nearest.\n\n";
  text += markdown_header({"parameter", "from", "to", "base", "best"});
  for (std::size_t i = 0; i < search.over.size(); ++i) {
    text += fmt::format("| `{}` | {:g} | {:g} | {} | {} |\n", search.over[i].key, search.over[i].from,
                        search.over[i].to, base.settings[i].value, best.settings[i].value);
  }
  const auto names = quantity_names(search), wanted = wishes(search);
  const bool is_checked = !result.after.empty();
  std::vector<std::string> header = {"quantity", "wanted", "base, in the search", "best, in the search"};
  if (is_checked) header.insert(header.end(), {"base, checked", "best, checked"});
  header.emplace_back("change");
  text.append("\n").append(markdown_header(header));
  for (std::size_t i = 0; i < names.size(); ++i) {
    double before = quantity(base, i), after = quantity(best, i);
    text += fmt::format("| {} | {} | {:.4g} | {:.4g} |", names[i], wanted[i], before, after);
    if (is_checked) {
      before = result.before[i].value;
      after = result.after[i].value;
      text += fmt::format(" {} | {} |", estimate_text(result.before[i]), estimate_text(result.after[i]));
    }
    text += fmt::format(" {} |\n", change_text(before, after));
  }
  if (!is_checked) return text + "\n";
  return text + fmt::format(
                    "\nChecked: both again with {} independent draws that the search has not seen, with intervals of "
                    "{:g} % confidence. The change is that of the checked values.\n\n",
                    search.check, 100 * study.estimate.confidence);
}

}  // namespace netpocket
