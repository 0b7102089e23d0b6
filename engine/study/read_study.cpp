#include "engine/study/read_study.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "engine/base/file_kind.h"
#include "engine/sampling/design.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/toml_depth.h"
#include "engine/study/read_campaign.h"
#include "engine/study/read_search.h"
#include "engine/study/read_uncertain.h"
#include "engine/study/toml_values.h"

namespace netpocket {
namespace {

constexpr int kDeepestKey = 8;  // dots

class StudyReader {
 public:
  explicit StudyReader(std::string path) : path_(std::move(path)) {}

  StudyResult read(const toml::table& file) {
    study_.path = path_;
    study_.name = study_.file = std::filesystem::path(path_).stem().string();
    if (is_scenario(file)) {
      add({.file = path_, .message = "is a scenario, not a study; a study names a scenario as its base"});
      return result();
    }
    check_names(file, {"name",       "description", "base",  "sampling",    "samples",  "seed",    "keep_recordings",
                       "findings",   "report",      "set",   "vary",        "point",    "variant", "uncertain",
                       "correlated", "estimate",    "until", "sensitivity", "ensemble", "remarks", "statement",
                       "optimise",   "rare"});
    read_text(file, "name", study_.name);
    read_text(file, "description", study_.description);
    read_base(file);
    if (!found_.ok()) return result();
    is_uncertain_ = file.contains("uncertain") || file.contains("correlated");
    study_.has_findings = !is_uncertain_;
    read_sampling(file);
    if (const toml::table* set = table(file, "set")) study_.settings = read_settings(*set, study_.base);
    // The following is checked with the settings of all points applied.
    Scenario scenario = study_.base;
    apply_settings(scenario, study_.settings);
    study_.places = read_named(file, "point", scenario);
    study_.variants = read_named(file, "variant", scenario);
    if (const toml::table* vary = table(file, "vary")) {
      read_axes(*vary, "", scenario);
      check_repeated_axes(*vary);
    }
    const ReportProblem report_problem = [this](const auto& node, const auto& key, const auto& message) {
      report(node, key, message);
    };
    study_.uncertain = read_uncertain(file, scenario, report_problem);
    read_campaign(file, study_, report_problem);
    if (const toml::table* ensemble = table(file, "ensemble")) read_ensemble(*ensemble, scenario);
    read_remarks(file);
    if (const toml::table* report = table(file, "report")) read_report(*report);
    read_search(file, scenario, study_, report_problem);
    if (found_.ok()) check_size();
    return result();
  }

 private:
  static bool is_scenario(const toml::table& file) {
    const auto found = entries(file);
    return !file.contains("base") && std::any_of(found.begin(), found.end(), [](const TomlEntry& e) {
      return find_parameter_group(e.key) != nullptr;
    });
  }

  StudyResult result() { return {std::move(study_), std::move(found_)}; }

  void report(int line, const std::string& key, const std::string& message) {
    add({.file = path_, .line = line, .key = key, .message = message});
  }
  // Adds each message only once.
  void add(Diagnostic problem) {
    if (said_.insert(problem.text()).second) found_.add(std::move(problem));
  }
  void report(const toml::node& node, const std::string& key, const std::string& message) {
    report(line_of(node), key, message);
  }

  void check_names(const toml::table& table, const std::vector<std::string_view>& known) {
    for (const auto& [key, node] : entries(table)) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      report(*node, key, fmt::format("is not a key of a study; these are: {}", fmt::join(known, ", ")));
    }
  }

  void read_text(const toml::table& table, std::string_view key, std::string& text) {
    const toml::node* node = table.get(key);
    if (!node) return;
    const auto value = node->value_exact<std::string>();
    if (!value) return report(*node, std::string(key), "expects a text in quotes");
    text = *value;
  }

  const toml::table* table(const toml::table& file, const std::string& key) {
    const toml::node* node = file.get(key);
    if (node && !node->is_table()) report(*node, key, fmt::format("is a table: write [{}]", key));
    return node ? node->as_table() : nullptr;
  }

  void read_base(const toml::table& file) {
    std::string base;
    read_text(file, "base", base);
    if (base.empty()) return report(1, "base", "names the scenario that the study starts from, e.g. \"../case1.toml\"");
    if (std::filesystem::path(base).is_absolute()) {
      return report(*file.get("base"), "base",
                    netpocket::quoted(base) + " is an absolute path; a base is named relative to the study's file");
    }
    ScenarioResult scenario = read_scenario_file((std::filesystem::path(path_).parent_path() / base).string());
    for (const Diagnostic& diagnostic : scenario.diagnostics.list()) found_.add(diagnostic);
    study_.base = std::move(scenario.scenario);
  }

  void read_sampling(const toml::table& file) {
    static const std::vector<std::pair<std::string, Sampling>> kinds = {{"grid", Sampling::grid},
                                                                        {"halton", Sampling::halton},
                                                                        {"monte_carlo", Sampling::monte_carlo},
                                                                        {"latin_hypercube", Sampling::latin_hypercube},
                                                                        {"sobol", Sampling::sobol}};
    std::string sampling = is_uncertain_ ? "monte_carlo" : "grid";
    read_text(file, "sampling", sampling);
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == sampling; });
    if (kind == kinds.end()) {
      report(*file.get("sampling"), "sampling",
             "expects \"grid\", \"halton\", \"monte_carlo\", \"latin_hypercube\" or \"sobol\", not " +
                 netpocket::quoted(sampling));
    } else {
      study_.sampling = kind->second;
    }
    const auto samples = read_whole(file, "samples", 1, static_cast<std::int64_t>(kMostStudyPoints));
    const bool has_own_points = file.contains("sensitivity") || file.contains("rare");
    if (study_.sampling != Sampling::grid && !samples && !has_own_points) {
      report(1, "samples", fmt::format("says how many points sampling = \"{}\" takes", sampling));
    }
    study_.samples = static_cast<int>(samples.value_or(0));
    study_.seed = read_whole(file, "seed", 0, INT32_MAX).value_or(1);
    read_switch(file, "keep_recordings", study_.keep_recordings);
    read_switch(file, "findings", study_.has_findings);
  }

  void read_switch(const toml::table& file, const std::string& key, bool& value) {
    const toml::node* node = file.get(key);
    if (node && !node->is_boolean()) report(*node, key, "expects true or false");
    if (node) value = node->value_or(value);
  }

  std::optional<std::int64_t> read_whole(const toml::table& table, const std::string& key, std::int64_t lowest,
                                         std::int64_t highest) {
    const toml::node* node = table.get(key);
    if (!node) return std::nullopt;
    const auto value = node->value_exact<std::int64_t>();
    if (value && *value >= lowest && *value <= highest) return value;
    report(*node, key, fmt::format("expects a whole number from {} to {}", lowest, highest));
    return std::nullopt;
  }

  // Settings of a table. Keys are in tables by group, or dotted and in quotes. Each is checked on `scenario` by itself.
  std::vector<Setting> read_settings(const toml::table& table, const Scenario& scenario,
                                     const std::string& prefix = "") {
    std::vector<Setting> settings;
    for (const auto& [name, node] : entries(table)) {
      if (prefix.empty() && name == "name") continue;  // name of the point or variant, not of the scenario
      const std::string key = prefix.empty() ? name : prefix + "." + name;
      if (const toml::table* group = node->as_table()) {
        for (Setting& setting : read_settings(*group, scenario, key)) settings.push_back(std::move(setting));
        continue;
      }
      Setting setting{key, value_text(*node)};
      try_setting(*node, scenario, setting);
      settings.push_back(std::move(setting));
    }
    if (prefix.empty()) check_repeated(table, settings);
    return settings;
  }

  // A key may be in a table of its group or in quotes, but not both.
  void check_repeated(const toml::table& table, const std::vector<Setting>& settings) {
    std::set<std::string> keys;
    for (const Setting& setting : settings) {
      if (!keys.insert(setting.key).second) report(table, setting.key, "is set twice");
    }
  }

  std::vector<Diagnostic> setting_problems(const toml::node& node, Scenario scenario, const Setting& setting) const {
    const auto file = node.value<std::string>();
    if (setting.key == "target.mesh_file" && file && std::filesystem::path(*file).is_absolute()) {
      return {{.file = path_,
               .line = line_of(node),
               .key = setting.key,
               .message = netpocket::quoted(*file) +
                          " is an absolute path; a study names meshes in the folder of its base or below"}};
    }
    std::vector<Diagnostic> problems = apply_setting(scenario, setting).list();
    for (Diagnostic& problem : problems) {
      problem.file = path_;
      problem.line = line_of(node);
    }
    return problems;
  }

  void try_setting(const toml::node& node, const Scenario& scenario, const Setting& setting) {
    for (Diagnostic& problem : setting_problems(node, scenario, setting)) add(std::move(problem));
  }

  // Reads [[point]] or [[variant]]: each has a name and settings. Without any, the list has one without name and
  // settings.
  std::vector<NamedSettings> read_named(const toml::table& file, const std::string& key, const Scenario& scenario) {
    const toml::node* node = file.get(key);
    if (!node) return {{}};
    if (!node->is_array_of_tables()) {
      report(*node, key, fmt::format("is a list of tables: write [[{}]] before each", key));
      return {{}};
    }
    std::vector<NamedSettings> list;
    for (const toml::node& element : *node->as_array()) {
      const toml::table& entry = *element.as_table();
      NamedSettings named;
      read_text(entry, "name", named.name);
      const auto same = [&](const NamedSettings& other) { return other.name == named.name; };
      const auto is_bad = [](char c) { return c == '/' || static_cast<unsigned char>(c) < 0x20; };
      if (named.name.empty() || std::any_of(named.name.begin(), named.name.end(), is_bad)) {
        report(element, key + ".name", "expects a name in one line, without '/'");
      } else if (std::any_of(list.begin(), list.end(), same)) {
        report(element, key + ".name", netpocket::quoted(named.name) + " is the name of another one");
      }
      named.settings = read_settings(entry, scenario);
      list.push_back(std::move(named));
    }
    return list;
  }

  // Reads the axes of a table and of its inner tables. A table with "from" or "to" is a range.
  void read_axes(const toml::table& table, const std::string& prefix, const Scenario& scenario) {
    for (const auto& [name, node] : entries(table)) {
      const std::string key = prefix.empty() ? name : prefix + "." + name;
      if (const toml::array* list = node->as_array()) {
        read_list(key, *list, scenario);
      } else if (const toml::table* inner = node->as_table()) {
        inner->contains("from") || inner->contains("to") ? read_range(key, *inner, scenario)
                                                         : read_axes(*inner, key, scenario);
      } else {
        report(*node, key, "expects a list of values or { from = ..., to = ..., steps = ... }");
      }
    }
  }

  void check_repeated_axes(const toml::table& vary) {
    std::set<std::string> keys;
    for (const Axis& axis : study_.axes) {
      if (!keys.insert(axis.key).second) report(vary, axis.key, "is varied twice");
    }
  }

  void read_list(const std::string& key, const toml::array& list, const Scenario& scenario) {
    if (list.empty()) return report(list, key, "has no values");
    Axis axis{.key = key};
    std::set<std::string> said;  // a problem that all values share is reported once
    for (const toml::node& value : list) {
      axis.values.push_back(value_text(value));
      for (Diagnostic& problem : setting_problems(value, scenario, {key, axis.values.back()})) {
        if (said.insert(problem.message).second) add(std::move(problem));
      }
    }
    study_.axes.push_back(std::move(axis));
  }

  void read_range(const std::string& key, const toml::table& range, const Scenario& scenario) {
    check_names(range, {"from", "to", "steps", "scale"});
    Axis axis{.key = key};
    const Parameter* parameter = find_parameter(key, scenario);
    axis.whole = parameter && parameter->type == ParameterType::integer;
    const auto number = [&](const char* end, double& value) {
      const toml::node* node = range.get(end);
      if (!node || !node->is_number()) return report(range, key, fmt::format("needs the number '{}'", end));
      value = *node->value<double>();
      try_setting(*node, scenario, {key, value_text(*node)});
    };
    number("from", axis.from);
    number("to", axis.to);
    if (!(axis.from < axis.to)) report(range, key, "'from' must be below 'to'");
    std::string scale = "linear";
    read_text(range, "scale", scale);
    axis.logarithmic = scale == "log";
    if (scale != "linear" && scale != "log") report(range, key, "'scale' is \"linear\" or \"log\"");
    if (axis.logarithmic && !(axis.from > 0)) report(range, key, "a scale \"log\" needs 'from' above 0");
    const auto steps = read_whole(range, "steps", 2, static_cast<std::int64_t>(kMostStudyPoints));
    const bool is_grid = study_.sampling == Sampling::grid || is_uncertain_;
    if (is_grid && !steps && !range.contains("steps")) {
      report(range, key, "a grid needs 'steps', how many values to take");
    }
    axis.steps = static_cast<int>(steps.value_or(2));
    study_.axes.push_back(std::move(axis));
  }

  void read_ensemble(const toml::table& ensemble, const Scenario& scenario) {
    check_names(ensemble, {"runs", "perturbation"});
    if (!ensemble.contains("runs")) report(ensemble, "ensemble.runs", "says how many draws to make, e.g. 16");
    study_.ensemble.runs =
        static_cast<int>(read_whole(ensemble, "runs", 2, static_cast<std::int64_t>(kMostStudyPoints)).value_or(0));
    const toml::node* node = ensemble.get("perturbation");
    if (!node) return;
    const auto value = node->value<double>();
    if (!node->is_number() || !(*value > 0)) return report(*node, "perturbation", "expects a length in m above 0");
    study_.ensemble.perturbation = *value;
    try_setting(*node, scenario, {"solver.perturbation", value_text(*node)});
  }

  void read_remarks(const toml::table& file) {
    const toml::table* remarks = table(file, "remarks");
    if (!remarks) return;
    for (const auto& [key, node] : entries(*remarks)) {
      const auto text = node->value_exact<std::string>();
      if (!text) report(*node, "remarks." + key, "expects a text in quotes");
      study_.remarks[key] = text.value_or("");
    }
  }

  void read_report(const toml::table& file) {
    check_names(file, {"of", "best", "show"});
    std::string of = "findings";
    read_text(file, "of", of);
    if (of != "findings" && of != "search" && of != "statements") {
      report(*file.get("of"), "report.of",
             "expects \"findings\", \"search\" or \"statements\", not " + netpocket::quoted(of));
    }
    study_.report.of = of == "search"       ? ReportOf::search
                       : of == "statements" ? ReportOf::statements
                                            : ReportOf::findings;
    if (of == "statements" && study_.statements.empty())
      report(file, "report.of", "\"statements\" needs a [[statement]]");
    study_.report.best = static_cast<int>(read_whole(file, "best", 0, INT32_MAX).value_or(0));
    if (!file.contains("show")) return;
    const toml::array* show = file.get_as<toml::array>("show");
    if (!show || !show->is_homogeneous<std::string>()) {
      return report(*file.get("show"), "report.show", "expects a list of findings or columns, e.g. [\"F5\", \"F10\"]");
    }
    for (const toml::node& id : *show) study_.report.show.push_back(*id.value<std::string>());
  }

  // What uncertain inputs and their designs need.
  void check_campaign() {
    const int coordinates = coordinate_count(study_.uncertain);
    const auto has_steps = [](const UncertainInput& input) {
      const auto* number = std::get_if<UncertainNumber>(&input);
      return number && number->steps >= 1;
    };
    if (study_.sampling == Sampling::grid && !std::ranges::all_of(study_.uncertain, has_steps)) {
      report(1, "uncertain", "a grid needs 'steps' for each input, and takes neither directions nor correlated inputs");
      study_.sampling = Sampling::monte_carlo;
    }
    if (coordinates > kMostDimensions || static_cast<int>(study_.axes.size()) > kMostDimensions) {
      report(1, "uncertain",
             fmt::format("takes {} coordinates; a design has at most {}", coordinates, kMostDimensions));
    }
    const bool is_one_group = study_.places.size() == 1 && study_.axes.empty() && study_.ensemble.runs == 0;
    const bool is_sensitivity = study_.sensitivity.method != SensitivityMethod::none;
    const bool is_sobol = study_.sensitivity.method == SensitivityMethod::sobol;
    if (is_sensitivity && (study_.uncertain.empty() || study_.sampling == Sampling::grid)) {
      report(1, "sensitivity", "needs [uncertain] inputs, and no sampling of its own");
    }
    if (is_sensitivity && study_.until.half_width > 0) report(1, "until", "does not go with [sensitivity]");
    if (is_sobol && 2 * coordinates > kMostDimensions) {
      report(1, "sensitivity",
             fmt::format("takes {} coordinates; a design has at most {}", 2 * coordinates, kMostDimensions));
    }
    if (study_.until.half_width > 0 && (study_.uncertain.empty() || !is_one_group)) {
      report(1, "until", "needs [uncertain] inputs, one [[point]] at most, no [vary] and no [ensemble]");
    }
  }

  void check_size() {
    if (study_.sampling == Sampling::halton && study_.axes.size() > kMostSampledAxes && study_.uncertain.empty()) {
      report(1, "vary",
             fmt::format("{} axes are more than sampling = \"halton\" spreads evenly ({})", study_.axes.size(),
                         kMostSampledAxes));
    }
    check_campaign();
    const bool is_uncertain = !study_.uncertain.empty();
    const bool is_sensitivity = study_.sensitivity.method != SensitivityMethod::none;
    double points = study_.sampling == Sampling::grid ? 1 : study_.samples;
    if (is_sensitivity) points = study_.sensitivity.point_count(coordinate_count(study_.uncertain));
    if (study_.sampling == Sampling::grid || is_uncertain) {
      for (const Axis& axis : study_.axes) {
        points *= axis.values.empty() ? axis.steps : static_cast<double>(axis.values.size());
      }
    }
    if (study_.sampling == Sampling::grid) {
      for (const UncertainInput& input : study_.uncertain) points *= std::get<UncertainNumber>(input).steps;
    }
    points = points * static_cast<double>(study_.places.size()) + study_.ensemble.runs;
    if (points > static_cast<double>(kMostStudyPoints)) {
      report(1, "vary", fmt::format("{:.3g} points are more than {}", points, kMostStudyPoints));
    }
  }

  std::string path_;
  std::set<std::string> said_;
  bool is_uncertain_ = false;  // has uncertain inputs, the axes of which are a grid whatever the sampling
  Study study_;
  Diagnostics found_;
};

StudyResult failure(Diagnostic diagnostic) {
  StudyResult result;
  result.diagnostics.add(std::move(diagnostic));
  return result;
}

}  // namespace

StudyResult read_study_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return failure({.file = path, .message = "is a folder"});
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return failure({.file = path, .message = fmt::format("cannot be read: {}", std::strerror(errno))});
  }
  std::string text(kLargestStudyFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (const auto other = marked_description(std::string_view(text).substr(0, kContentBytes)); !other.empty()) {
    return failure({.file = path, .message = fmt::format("is {}, not a study", other)});
  }
  if (text.size() > kLargestStudyFile) {
    return failure({.file = path, .message = fmt::format("is larger than {} bytes", kLargestStudyFile)});
  }
  if (const int line = line_of_too_deep_key(text, kDeepestKey)) {
    return failure({.file = path, .line = line, .message = fmt::format("a key with more than {} dots", kDeepestKey)});
  }
  try {
    return StudyReader(path).read(toml::parse(text));
  } catch (const toml::parse_error& error) {
    return failure({.file = path,
                    .line = static_cast<int>(error.source().begin.line),
                    .message = std::string(error.description())});
  }
}

}  // namespace netpocket
