#include "engine/study/campaign_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/statistics/empirical_distribution.h"
#include "engine/study/report_text.h"
#include "engine/study/worst_captures.h"

namespace netpocket {
namespace {

constexpr std::size_t kWorst = 12;

std::string unit_text(const std::string& unit) { return unit == "1" ? "" : unit; }

std::string inputs_section(const StudyResults& results) {
  std::string text =
      "## What is uncertain\n\nQuantiles of the values that the runs used, read back from the simulation.\n\n" +
      markdown_header({"input", "unit", "least", "5 %", "median", "95 %", "largest"});
  for (const ResultColumn& input : results.inputs) {
    std::vector<double> values;
    std::ranges::copy_if(input.values, std::back_inserter(values), [](double v) { return std::isfinite(v); });
    const EmpiricalDistribution distribution(values);
    text += fmt::format("| `{}` | {} |", input.name, unit_text(input.unit));
    for (const double fraction : {0.0, 0.05, 0.5, 0.95, 1.0})
      text += fmt::format(" {:.3g} |", distribution.quantile(fraction));
    text += "\n";
  }
  return text + "\n";
}

std::string probability_section(const Study& study, const StudyOutcome& outcome) {
  std::string text = "## Probability of capture\n\n" +
                     fmt::format("{:g} % confidence.\n\n", 100 * study.estimate.confidence) +
                     markdown_header({"group", "variant", "captured", "judged", "not judged", "refused", "probability",
                                      "Wilson", "Clopper-Pearson"});
  for (const GroupEstimate& e : outcome.estimates) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {:.4f} | {:.4f} to {:.4f} | {:.4f} to {:.4f} |\n", e.group + 1,
                    markdown_cell(e.variant), e.tally.captured, e.tally.judged, e.tally.not_judged, e.refused,
                    e.probability(), e.wilson.lower, e.wilson.upper, e.clopper_pearson.lower, e.clopper_pearson.upper);
  }
  return text + "\n";
}

std::string quantiles_section(const StudyOutcome& outcome) {
  std::string rows;
  for (const GroupEstimate& e : outcome.estimates) {
    for (const QuantileOfColumn& q : e.quantiles) {
      rows += fmt::format("| `{}` | {} | {:g} % | {:.4g} | {} | {} |\n", q.column, markdown_cell(e.variant),
                          100 * q.fraction, q.value, interval_text(q.interval), q.count);
    }
  }
  if (rows.empty()) return "";
  return "## Quantiles\n\n" + markdown_header({"column", "variant", "share below", "value", "interval", "values"}) +
         rows + "\n";
}

// Rows of runs, the least escape depth first; those without one last.
std::string worst_section(const StudyResults& results) {
  const ResultColumn* depth = results.find("escape_depth");
  if (!depth) return "";
  std::vector<std::string> header = {"point", "captured", "escape_depth (m)"};
  for (const ResultColumn& input : results.inputs) header.push_back(input.name);
  std::string text =
      "## The worst captures\n\nThose in which the target's centre came nearest to the mouth's plane, or beyond "
      "it.\n\n" +
      markdown_header(header);
  for (const std::size_t i : worst_captures(results, {.by = depth->name}, kWorst)) {
    const char* captured = std::isnan(results.captured[i]) ? "not judged" : results.captured[i] == 1 ? "yes" : "no";
    text += fmt::format("| {} | {} | {:.3g} |", results.points[i], captured, depth->values[i]);
    for (const ResultColumn& input : results.inputs) text += fmt::format(" {:.3g} |", input.values[i]);
    text += "\n";
  }
  return text + "\n";
}

// A bootstrap cannot tell what never happened. By the rule of three 3 of n blocks may change with an input although
// none did, of which each adds 1/(2 n variance) to the index; the variance of yes or no is 1/4 at most.
std::string limit_of_bootstrap(const Study& study) {
  const StudySensitivity& sensitivity = study.sensitivity;
  if (sensitivity.method != SensitivityMethod::sobol || sensitivity.of != "captured") return "";
  return fmt::format(
      "Intervals are those of a bootstrap over the {0} blocks. One from 0 to 0 means that the input changed the "
      "outcome in no block, which leaves room for an index of {1:.2g} or so (3 of {0} blocks).\n\n",
      sensitivity.size, 6.0 / sensitivity.size);
}

}  // namespace

std::string campaign_report(const Study& study, const StudyOutcome& outcome, const StudyResults& results) {
  std::string text = fmt::format(
      "# {}\n\n{}.\n\n{} points, {} done, {} refused as not valid, {} with a run that diverged{}.\n\n", study.name,
      study.description, outcome.points, outcome.points_done, outcome.refused, outcome.diverged,
      outcome.limited > 0 ? fmt::format(", {} with one that reached its limit of steps", outcome.limited) : "");
  text += inputs_section(results);
  if (!outcome.sensitivities.empty()) {
    return text + "## Sensitivity\n\n```\n" + sensitivity_text(study, outcome.sensitivities) + "```\n\n" +
           limit_of_bootstrap(study);
  }
  text += probability_section(study, outcome) + quantiles_section(outcome);
  return text + worst_section(results);
}

}  // namespace netpocket
