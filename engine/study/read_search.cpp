#include "engine/study/read_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scenario/parameters.h"
#include "engine/study/optimisation.h"
#include "engine/study/rare_failure.h"
#include "engine/study/read_study.h"

namespace netpocket {
namespace {

class SearchReader {
 public:
  SearchReader(const Scenario& scenario, Study& study, const ReportProblem& report)
      : scenario_(scenario), study_(study), report_(report) {}

  void read_optimisation(const toml::table& table) {
    check_names(table,
                {"minimise", "maximise", "statistic", "over", "constraint", "candidates", "population", "restarts",
                 "step", "least_step", "check"},
                report_);
    StudyOptimisation& search = study_.optimisation;
    search.is_maximised = table.contains("maximise");
    if (search.is_maximised == table.contains("minimise")) {
      report_(table, "optimise", "needs either 'minimise' or 'maximise', a column of the table");
    }
    search.objective = {text(table, search.is_maximised ? "maximise" : "minimise"), statistic(table)};
    if (!table.contains("candidates")) report_(table, "optimise.candidates", "says how many candidates to run");
    search.candidates = whole_number(table, "candidates", 2, static_cast<int>(kMostStudyPoints), 2, report_);
    search.population = whole_number(table, "population", 4, 10000, 0, report_);
    search.restarts = whole_number(table, "restarts", 0, 20, search.restarts, report_);
    search.step = between(table, "step", 0, 1, search.step);
    search.least_step = between(table, "least_step", 0, 1, search.least_step);
    search.check = whole_number(table, "check", 30, static_cast<int>(kMostStudyPoints), search.check, report_);
    const toml::table* over = table.get_as<toml::table>("over");
    if (over) read_ranges(*over, "");
    if (search.over.empty()) {
      report_(table, "optimise.over", "names the parameters to choose: write [optimise.over], then a range for each");
    }
    if (const toml::node* constraints = table.get("constraint")) read_constraints(*constraints);
  }

  void read_rare(const toml::table& table) {
    check_names(table, {"of", "at_most", "at_least", "samples", "levels"}, report_);
    StudyRareFailure& rare = study_.rare;
    rare.of = text(table, "of");
    rare.is_above = table.contains("at_least");
    if (rare.is_above == table.contains("at_most")) {
      report_(table, "rare", "needs either 'at_most' or 'at_least', the number at which a capture fails");
    }
    rare.limit = number(table, rare.is_above ? "at_least" : "at_most").value_or(0);
    rare.samples = whole_number(table, "samples", 100, static_cast<int>(kMostStudyPoints), rare.samples, report_);
    if (rare.samples % 10 != 0) report_(table, "rare.samples", "is a multiple of 10");
    rare.levels = whole_number(table, "levels", 1, 15, rare.levels, report_);
  }

  // What a search needs, and what does not go with it.
  void check(const toml::table& file) {
    const bool optimises = study_.optimisation.candidates > 0;
    const char* name = optimises ? "optimise" : "rare";
    const toml::node& node = *file.get(name);
    if (optimises && !study_.rare.of.empty()) report_(node, "optimise", "does not go with [rare]");
    for (const char* other : {"vary", "point", "ensemble", "until", "sensitivity", "statement"}) {
      if (file.contains(other)) report_(*file.get(other), other, fmt::format("does not go with [{}]", name));
    }
    if (study_.variants.size() > 1) report_(node, name, "takes one [[variant]] at most");
    if (study_.keep_recordings || (file.contains("findings") && study_.has_findings)) {
      report_(node, name, "keeps no recordings and judges no findings");
    }
    study_.has_findings = false;
    if (!optimises && study_.uncertain.empty()) report_(node, "rare", "needs [uncertain] inputs");
    if (study_.sampling == Sampling::grid && !study_.uncertain.empty()) {
      report_(node, name, "takes no grid of the uncertain inputs");
      return;
    }
    for (const char* key : {"sampling", "samples"}) {
      if (!optimises && file.contains(key)) {
        report_(*file.get(key), key, "does not go with [rare], which chooses its points itself");
      }
    }
    if (!optimises) study_.samples = study_.rare.samples;  // of its first level
    const std::size_t points = optimises ? planned_points(study_) : planned_rare_points(study_);
    if (points > kMostStudyPoints) {
      report_(node, name, fmt::format("takes {} points, more than {}", points, kMostStudyPoints));
    }
  }

 private:
  // A table with "from" or "to" is a range.
  void read_ranges(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : entries(table)) {
      const std::string key = prefix.empty() ? name : prefix + "." + name;
      const toml::table* inner = node->as_table();
      if (!inner) {
        report_(*node, key, "expects a range, e.g. { from = 5, to = 10 }");
      } else if (inner->contains("from") || inner->contains("to")) {
        read_range(key, *inner);
      } else {
        read_ranges(*inner, key);
      }
    }
  }

  void read_range(const std::string& key, const toml::table& range) {
    check_names(range, {"from", "to", "scale"}, report_);
    Axis axis{.key = key};
    axis.from = number(range, "from").value_or(0);
    axis.to = number(range, "to").value_or(1);
    for (const char* end : {"from", "to"}) check_setting(range, {key, value_text(*end_of(range, end))});
    if (!number_of(scenario_, key)) report_(range, key, "is no number, which a search could choose");
    if (!(axis.from < axis.to)) report_(range, key, "'from' must be below 'to'");
    const Parameter* parameter = find_parameter(key, scenario_);
    axis.whole = parameter && parameter->type == ParameterType::integer;
    const std::string scale = range["scale"].value_or(std::string("linear"));
    axis.logarithmic = scale == "log";
    if (scale != "linear" && scale != "log") report_(range, key, "'scale' is \"linear\" or \"log\"");
    if (axis.logarithmic && !(axis.from > 0)) report_(range, key, "a scale \"log\" needs 'from' above 0");
    for (const UncertainInput& input : study_.uncertain) {
      if (std::ranges::count(keys_of(input), key) > 0) report_(range, key, "is [uncertain], and cannot be chosen too");
    }
    study_.optimisation.over.push_back(std::move(axis));
  }

  static const toml::node* end_of(const toml::table& range, const char* end) {
    const toml::node* node = range.get(end);
    return node ? node : &range;
  }

  void check_setting(const toml::table& range, const Setting& setting) {
    Scenario scenario = scenario_;
    const Diagnostics problems = apply_setting(scenario, setting);
    for (const Diagnostic& problem : problems.list()) {
      report_(range, problem.key, problem.message);
    }
  }

  void read_constraints(const toml::node& node) {
    if (!node.is_array_of_tables()) {
      return report_(node, "optimise.constraint", "is a list of tables: write [[optimise.constraint]] before each");
    }
    for (const toml::node& element : *node.as_array()) {
      const toml::table& table = *element.as_table();
      check_names(table, {"of", "statistic", "at_most", "at_least"}, report_);
      StudyConstraint constraint{
          {text(table, "of"), statistic(table)}, number(table, "at_most", false), number(table, "at_least", false)};
      if (!constraint.at_most && !constraint.at_least) {
        report_(table, "optimise.constraint", "needs 'at_most' or 'at_least'");
      }
      study_.optimisation.constraints.push_back(std::move(constraint));
    }
  }

  // Nothing for the mean.
  std::optional<double> statistic(const toml::table& table) {
    const toml::node* node = table.get("statistic");
    if (!node) return std::nullopt;
    const std::string name = node->value<std::string>().value_or("");
    if (name == "mean") return std::nullopt;
    if (name == "least") return 0;
    if (name == "largest") return 1;
    const double share = node->is_number() ? *node->value<double>() : -1;
    if (!(share >= 0 && share <= 1)) {
      report_(*node, "statistic", "is \"mean\", \"least\", \"largest\" or the share of a quantile, e.g. 0.95");
    }
    return share;
  }

  std::string text(const toml::table& table, const std::string& key) {
    const auto value = table[key].value_exact<std::string>();
    if (!value || value->empty()) report_(table, key, "names a column of the table (study_columns.csv)");
    return value.value_or("");
  }

  std::optional<double> number(const toml::table& table, const std::string& key, bool is_needed = true) {
    const toml::node* node = table.get(key);
    if (!node && !is_needed) return std::nullopt;
    const auto value = node && node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) {
      report_(node ? *node : table, key, "expects a finite number");
      return std::nullopt;
    }
    return value;
  }

  double between(const toml::table& table, const std::string& key, double lowest, double highest, double otherwise) {
    if (!table.contains(key)) return otherwise;
    const auto value = number(table, key);
    if (value && *value > lowest && *value < highest) return *value;
    report_(table, key, fmt::format("expects a number between {} and {}", lowest, highest));
    return otherwise;
  }

  const Scenario& scenario_;
  Study& study_;
  const ReportProblem& report_;
};

}  // namespace

void read_search(const toml::table& file, const Scenario& scenario, Study& study, const ReportProblem& report) {
  SearchReader reader(scenario, study, report);
  for (const char* key : {"optimise", "rare"}) {
    const toml::node* node = file.get(key);
    if (node && !node->is_table()) return report(*node, key, fmt::format("is a table: write [{}]", key));
  }
  if (const toml::table* table = file.get_as<toml::table>("optimise")) reader.read_optimisation(*table);
  if (const toml::table* table = file.get_as<toml::table>("rare")) reader.read_rare(*table);
  if (study.is_search()) reader.check(file);
}

}  // namespace netpocket
