#include "engine/study/read_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/study/read_study.h"

namespace netpocket {
namespace {

class CampaignReader {
 public:
  CampaignReader(Study& study, const ReportProblem& report) : study_(study), report_(report) {}

  void read_estimate(const toml::table& table) {
    check_names(table, {"confidence", "quantiles", "of"}, report_);
    study_.estimate.confidence = share(table, "confidence", study_.estimate.confidence);
    if (const toml::node* quantiles = table.get("quantiles")) {
      const toml::array* list = quantiles->as_array();
      const auto is_share = [](const toml::node& q) {
        return q.is_number() && *q.value<double>() >= 0 && *q.value<double>() <= 1;
      };
      if (!list || !std::ranges::all_of(*list, is_share)) {
        return report_(*quantiles, "estimate.quantiles", "expects a list of numbers from 0 to 1, e.g. [0.05, 0.5]");
      }
      study_.estimate.quantiles.clear();
      for (const toml::node& q : *list) study_.estimate.quantiles.push_back(*q.value<double>());
    }
    if (!table.contains("of")) return;
    const toml::array* of = table.get_as<toml::array>("of");
    if (!of || !of->is_homogeneous<std::string>()) {
      return report_(*table.get("of"), "estimate.of", "expects a list of columns, e.g. [\"utilisation_peak\"]");
    }
    for (const toml::node& name : *of) study_.estimate.of.push_back(*name.value<std::string>());
  }

  void read_until(const toml::table& table) {
    check_names(table, {"of", "half_width", "batch"}, report_);
    if (text(table, "of", "captured") != "captured") {
      report_(table, "until.of", "is \"captured\": the probability of capture");
    }
    if (!table.contains("half_width")) report_(table, "until.half_width", "says how narrow the interval is to be");
    study_.until.half_width = share(table, "half_width", 0.5);
    study_.until.batch = whole_number(table, "batch", 1, static_cast<int>(kMostStudyPoints), 100, report_);
  }

  void read_sensitivity(const toml::table& table) {
    check_names(table, {"method", "of", "blocks", "trajectories", "levels"}, report_);
    StudySensitivity& sensitivity = study_.sensitivity;
    const std::string method = text(table, "method", "sobol");
    if (method != "sobol" && method != "morris") {
      report_(table, "sensitivity.method", "is \"sobol\" (indices) or \"morris\" (screening)");
    }
    const bool is_sobol = method == "sobol";
    sensitivity.method = is_sobol ? SensitivityMethod::sobol : SensitivityMethod::morris;
    sensitivity.of = text(table, "of", "captured");
    const char* size = is_sobol ? "blocks" : "trajectories";
    if (!table.contains(size)) {
      report_(table, "sensitivity",
              fmt::format("method \"{}\" needs '{}': it takes (inputs + {}) points for each", method, size,
                          is_sobol ? 2 : 1));
    }
    sensitivity.size = whole_number(table, size, 2, static_cast<int>(kMostStudyPoints), 2, report_);
    sensitivity.levels = whole_number(table, "levels", 2, 1000, 4, report_);
    if (sensitivity.levels % 2 != 0) report_(table, "sensitivity.levels", "is an even number");
  }

  void read_statement(const toml::table& table) {
    check_names(table, {"text", "column", "variant", "against", "at_most", "at_least"}, report_);
    StudyStatement statement{.text = text(table, "text", ""),
                             .column = text(table, "column", ""),
                             .variant = text(table, "variant", study_.variants.front().name),
                             .against = text(table, "against", "")};
    if (statement.text.empty()) report_(table, "statement.text", "says what is stated, in a sentence");
    if (statement.column.empty()) report_(table, "statement.column", "names a column of the table (study_columns.csv)");
    for (const auto& [key, name] : {std::pair("variant", statement.variant), {"against", statement.against}}) {
      const bool is_known = std::ranges::count(study_.variants, name, &NamedSettings::name) > 0;
      if (table.contains(key) && !is_known)
        report_(*table.get(key), fmt::format("statement.{}", key), "is not the name of a [[variant]]");
    }
    statement.at_most = limit(table, "at_most");
    statement.at_least = limit(table, "at_least");
    if (!statement.at_most && !statement.at_least) report_(table, "statement", "needs 'at_most' or 'at_least'");
    study_.statements.push_back(std::move(statement));
  }

 private:
  std::optional<double> limit(const toml::table& table, const std::string& key) {
    const toml::node* node = table.get(key);
    if (!node) return std::nullopt;
    const auto value = node->is_number() ? node->value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) report_(*node, "statement." + key, "expects a finite number");
    return value;
  }

  std::string text(const toml::table& table, const std::string& key, const std::string& otherwise) {
    const toml::node* node = table.get(key);
    if (!node) return otherwise;
    const auto value = node->value_exact<std::string>();
    if (!value) report_(*node, key, "expects a text in quotes");
    return value.value_or(otherwise);
  }

  double share(const toml::table& table, const std::string& key, double otherwise) {
    const toml::node* node = table.get(key);
    if (!node) return otherwise;
    const double value = node->is_number() ? *node->value<double>() : 0;
    if (!(value > 0 && value < 1)) report_(*node, key, "expects a number between 0 and 1");
    return value;
  }

  Study& study_;
  const ReportProblem& report_;
};

}  // namespace

void read_campaign(const toml::table& file, Study& study, const ReportProblem& report) {
  CampaignReader reader(study, report);
  const auto read = [&](const char* key, void (CampaignReader::*use)(const toml::table&)) {
    const toml::node* node = file.get(key);
    if (node && !node->is_table()) report(*node, key, fmt::format("is a table: write [{}]", key));
    if (node && node->is_table()) (reader.*use)(*node->as_table());
  };
  read("estimate", &CampaignReader::read_estimate);
  read("until", &CampaignReader::read_until);
  read("sensitivity", &CampaignReader::read_sensitivity);
  const toml::node* statements = file.get("statement");
  if (!statements) return;
  if (!statements->is_array_of_tables())
    return report(*statements, "statement", "is a list of tables: write [[statement]] before each");
  for (const toml::node& statement : *statements->as_array()) reader.read_statement(*statement.as_table());
}

}  // namespace netpocket
