#include "engine/study/read_uncertain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"

namespace netpocket {
namespace {

const std::vector<std::string> kDistributions = {"normal",     "truncated_normal", "uniform", "log_normal",
                                                 "triangular", "discrete",         "samples", "direction"};

class UncertainReader {
 public:
  UncertainReader(const Scenario& scenario, const ReportProblem& report) : scenario_(scenario), report_(report) {}

  // Reads the inputs of a table and of its inner tables. A table with "distribution" is an input.
  void read(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : entries(table)) {
      const std::string key = prefix.empty() ? name : prefix + "." + name;
      const toml::table* inner = node->as_table();
      if (!inner) {
        report_(*node, key, "expects a distribution, e.g. { distribution = \"normal\", mean = 1, deviation = 0.1 }");
      } else if (inner->contains("distribution")) {
        for (const std::string& each : expanded(key, *inner)) read_input(each, *inner);
      } else {
        read(*inner, key);
      }
    }
  }

  void read_group(const toml::table& table) {
    check_names(table, "correlated", {"keys", "mean", "deviation", "correlation"});
    CorrelatedInputs group;
    const toml::array* keys = table.get_as<toml::array>("keys");
    if (!keys || keys->empty() || !keys->is_homogeneous<std::string>()) {
      return report_(table, "correlated.keys", "expects a list of keys, e.g. [\"target.mass\", \"contact.friction\"]");
    }
    for (const toml::node& key : *keys) group.keys.push_back(*key.value<std::string>());
    const auto count = static_cast<Eigen::Index>(group.keys.size());
    const std::vector<double> mean = numbers(table, "mean"), deviation = numbers(table, "deviation");
    group.normals.mean = Eigen::Map<const Eigen::VectorXd>(mean.data(), static_cast<Eigen::Index>(mean.size()));
    group.normals.deviation =
        Eigen::Map<const Eigen::VectorXd>(deviation.data(), static_cast<Eigen::Index>(deviation.size()));
    group.normals.correlation = matrix(table, count);
    if (group.normals.mean.size() != count || group.normals.deviation.size() != count) {
      return report_(table, "correlated", fmt::format("needs a mean and a deviation for each of the {} keys", count));
    }
    if (const std::string fault = find_fault(group.normals); !fault.empty()) {
      return report_(table, "correlated", fault);
    }
    add(table, group);
  }

  std::vector<UncertainInput> take() { return std::move(inputs_); }

 private:
  // "scatter.rod_stiffness[*][1]" stands for one input for each row of the list, each with draws of its own.
  std::vector<std::string> expanded(const std::string& key, const toml::table& table) {
    const auto star = key.find("[*]");
    if (star == key.npos) return {key};
    const Parameter* parameter = find_parameter(key.substr(0, star), scenario_);
    std::size_t count = parameter && parameter->type == ParameterType::vector ? 3 : 0;
    if (parameter && parameter->type == ParameterType::pairs) {
      count = std::get<std::vector<Eigen::Vector2d>>(parameter->get(scenario_)).size();
    }
    if (count == 0) {
      report_(table, key, "has nothing that [*] could stand for: name a list with rows, which [set] or the base gives");
    }
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < count; ++i) {
      keys.push_back(fmt::format("{}[{}]{}", key.substr(0, star), i, key.substr(star + 3)));
    }
    return keys;
  }

  void read_input(const std::string& key, const toml::table& table) {
    const auto name = table["distribution"].value<std::string>().value_or("");
    if (name == "direction") return read_direction(key, table);
    UncertainNumber input{.key = key, .distribution = Uniform{}};
    const auto distribution = read_distribution(key, table, {"relative", "steps"}, &input.choices);
    if (!distribution) return;
    input.distribution = *distribution;
    input.is_relative = table["relative"].value_or(false);
    input.steps = static_cast<int>(std::clamp<std::int64_t>(table["steps"].value_or(std::int64_t{0}), 0, 100000));
    const Parameter* parameter = find_parameter(key, scenario_);
    const bool is_vector = parameter && parameter->type == ParameterType::vector;
    if (input.is_relative && !is_vector && !number_of(scenario_, key)) {
      return report_(table, key, "is no number and no vector, so no value of it can be relative");
    }
    add(table, input);
  }

  void read_direction(const std::string& key, const toml::table& table) {
    check_names(table, key, {"distribution", "size"});
    UncertainDirection input{.key = key, .size = Uniform{}};
    const toml::node* size = table.get("size");
    if (size && size->is_table()) {
      const auto distribution = read_distribution(key + ".size", *size->as_table(), {}, nullptr);
      if (!distribution) return;
      input.size = *distribution;
    } else if (size && size->is_number()) {
      input.size = Samples{{*size->value<double>()}};
    } else {
      return report_(table, key, "needs 'size', the length of the vector: a number or a distribution");
    }
    add(table, input);
  }

  // Nothing, and a report, if it is wrong. `choices`: takes the values of a discrete distribution that are no numbers.
  std::optional<Distribution> read_distribution(const std::string& key, const toml::table& table,
                                                std::vector<std::string> more, std::vector<std::string>* choices) {
    const auto name = table["distribution"].value<std::string>().value_or("");
    if (std::ranges::find(kDistributions, name) == kDistributions.end() || name == "direction") {
      report_(table, key,
              fmt::format("'distribution' is one of {}; this is {}", fmt::join(kDistributions, ", "),
                          netpocket::quoted(name)));
      return std::nullopt;
    }
    bool is_complete = true;
    std::vector<std::string> known = {"distribution"};
    known.insert(known.end(), more.begin(), more.end());
    const auto number = [&](const char* of) {
      known.emplace_back(of);
      const toml::node* node = table.get(of);
      if (node && node->is_number()) return *node->value<double>();
      report_(table, key, fmt::format("a distribution \"{}\" needs the number '{}'", name, of));
      is_complete = false;
      return 0.0;
    };
    Distribution distribution;
    if (name == "normal") distribution = Normal{number("mean"), number("deviation")};
    if (name == "truncated_normal") {
      distribution = TruncatedNormal{number("mean"), number("deviation"), number("min"), number("max")};
    }
    if (name == "uniform") distribution = Uniform{number("min"), number("max")};
    if (name == "log_normal") distribution = LogNormal{number("median"), number("log_deviation")};
    if (name == "triangular") distribution = Triangular{number("min"), number("mode"), number("max")};
    if (name == "samples") {
      known.emplace_back("values");
      distribution = Samples{numbers(table, "values")};
    }
    if (name == "discrete") {
      known.insert(known.end(), {"values", "weights"});
      distribution = discrete(table, choices);
    }
    check_names(table, key, known);
    if (!is_complete) return std::nullopt;
    if (const std::string fault = find_fault(distribution); !fault.empty()) {
      report_(table, key, fault);
      return std::nullopt;
    }
    return distribution;
  }

  // Values that are no numbers are drawn by their place in the list.
  Discrete discrete(const toml::table& table, std::vector<std::string>* choices) {
    Discrete found;
    found.weights = table.contains("weights") ? numbers(table, "weights") : std::vector<double>();
    const toml::array* values = table.get_as<toml::array>("values");
    const bool are_numbers =
        values && std::ranges::all_of(*values, [](const toml::node& value) { return value.is_number(); });
    if (!values || are_numbers || !choices) {
      found.values = numbers(table, "values");
      return found;
    }
    for (const toml::node& value : *values) choices->push_back(value_text(value));
    found.values.resize(choices->size());
    std::iota(found.values.begin(), found.values.end(), 0);
    return found;
  }

  std::vector<double> numbers(const toml::table& table, const std::string& key) {
    std::vector<double> found;
    const toml::array* list = table.get_as<toml::array>(key);
    if (!list) report_(table, key, "expects a list of numbers");
    for (std::size_t i = 0; list && i < list->size(); ++i) {
      const toml::node& value = *list->get(i);
      if (!value.is_number()) report_(value, key, "expects a list of numbers");
      found.push_back(value.value<double>().value_or(0));
    }
    return found;
  }

  Eigen::MatrixXd matrix(const toml::table& table, Eigen::Index size) {
    Eigen::MatrixXd found = Eigen::MatrixXd::Identity(size, size);
    const toml::array* rows = table.get_as<toml::array>("correlation");
    const auto is_wrong = [&](const toml::node& row) {
      return !row.is_array() || static_cast<Eigen::Index>(row.as_array()->size()) != size;
    };
    if (!rows || static_cast<Eigen::Index>(rows->size()) != size || std::ranges::any_of(*rows, is_wrong)) {
      report_(table, "correlation", fmt::format("expects {} lists of {} numbers each", size, size));
      return found;
    }
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < size; ++j) {
        const toml::array& row = *rows->get(static_cast<std::size_t>(i))->as_array();
        found(i, j) = row.get(static_cast<std::size_t>(j))->value<double>().value_or(std::nan(""));
      }
    }
    return found;
  }

  void check_names(const toml::table& table, const std::string& key, const std::vector<std::string>& known) {
    for (const auto& [name, node] : entries(table)) {
      if (std::ranges::find(known, name) != known.end()) continue;
      report_(*node, key, fmt::format("does not take '{}'; it takes {}", name, fmt::join(known, ", ")));
    }
  }

  void add(const toml::node& node, const UncertainInput& input) {
    const std::vector<double> middle(static_cast<std::size_t>(coordinate_count(input)), 0.5);
    for (const std::string& key : keys_of(input)) {
      const bool is_known = std::ranges::find(keys_, key) != keys_.end();
      if (is_known) report_(node, key, "is uncertain twice");
      keys_.push_back(key);
    }
    Scenario scenario = scenario_;
    for (const Setting& setting : drawn_settings(input, middle, scenario_)) {
      const Diagnostics problems = apply_setting(scenario, setting);
      for (const Diagnostic& problem : problems.list()) {
        report_(node, problem.key.empty() ? setting.key : problem.key, problem.message);
      }
    }
    inputs_.push_back(input);
  }

  const Scenario& scenario_;
  const ReportProblem& report_;
  std::vector<std::string> keys_;
  std::vector<UncertainInput> inputs_;
};

}  // namespace

std::vector<UncertainInput> read_uncertain(const toml::table& file, const Scenario& scenario,
                                           const ReportProblem& report) {
  UncertainReader reader(scenario, report);
  if (const toml::node* uncertain = file.get("uncertain")) {
    if (const toml::table* table = uncertain->as_table()) {
      reader.read(*table, "");
    } else {
      report(*uncertain, "uncertain", "is a table: write [uncertain]");
    }
  }
  if (const toml::node* correlated = file.get("correlated")) {
    if (!correlated->is_array_of_tables()) {
      report(*correlated, "correlated", "is a list of tables: write [[correlated]] before each");
      return reader.take();
    }
    for (const toml::node& group : *correlated->as_array()) reader.read_group(*group.as_table());
  }
  return reader.take();
}

}  // namespace netpocket
