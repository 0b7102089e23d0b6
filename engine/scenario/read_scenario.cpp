#include "engine/scenario/read_scenario.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <variant>

#include "engine/base/file_kind.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/toml_depth.h"
#include "engine/scenario/toml_value.h"

namespace netpocket {
namespace {

constexpr std::size_t kListedProblems = 20;
constexpr int kDeepestKey = 8;  // dots; keys of parameters have at most one

std::string unknown_text(std::string_view kind, std::optional<std::string_view> nearest) {
  if (nearest) return fmt::format("is not {}; did you mean '{}'?", kind, *nearest);
  return fmt::format("is not {}; scenarios/REFERENCE.md lists them all", kind);
}

// A message of the parser as one line of limited length. It may quote any text of the file.
std::string printable(std::string_view message) {
  constexpr std::size_t kLongest = 300;
  std::size_t end = std::min(message.size(), kLongest);
  while (end > 0 && end < message.size() && (static_cast<unsigned char>(message[end]) & 0xC0) == 0x80) --end;
  std::string line(message.substr(0, end));
  std::ranges::replace_if(
      line, [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; }, ' ');
  return end < message.size() ? line + "..." : line;
}

// The parsed table, or the problem that prevented parsing.
std::variant<toml::table, Diagnostic> parse(std::string_view text) {
  if (const int line = line_of_too_deep_key(text, kDeepestKey)) {
    return Diagnostic{.line = line, .message = fmt::format("a key with more than {} dots", kDeepestKey)};
  }
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    return Diagnostic{.line = static_cast<int>(error.source().begin.line), .message = printable(error.description())};
  }
}

// Sets the parameters that a parsed file contains.
class FileReader {
 public:
  FileReader(Scenario& scenario, std::map<std::string, int, std::less<>>& lines) : scenario_(scenario), lines_(lines) {}

  void read(const toml::table& file) {
    // The kind of the system decides which tables there are.
    if (const toml::node* system = file.get("system")) read_parameter("system", *system);
    for (const auto& [key, node] : file) {
      if (key.str() != "system") read_top(key.str(), node);
    }
  }

  // Sorted by line, with the name of the file.
  Diagnostics diagnostics(const std::string& file) {
    std::stable_sort(problems_.begin(), problems_.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
    Diagnostics result;
    for (std::size_t i = 0; i < std::min(problems_.size(), kListedProblems); ++i) {
      const Problem& problem = problems_[i];
      const std::string key = excerpt(problem.key);
      result.add({file, problem.line, key.substr(1, key.size() - 2), problem.message()});
    }
    if (problems_.size() > kListedProblems) {
      result.add({.file = file, .message = fmt::format("{} more problems", problems_.size() - kListedProblems)});
    }
    return result;
  }

 private:
  struct Problem {
    int line;
    std::string key;
    std::function<std::string()> message;  // called only if listed: finding similar names is slower than reading
  };

  void read_top(std::string_view key, const toml::node& node) {
    if (const ParameterList* list = find_parameter_list(key, scenario_.system)) {
      read_list(*list, node);
    } else if (find_parameter_group(key, scenario_.system) && !key.empty()) {
      read_group(key, node);
    } else if ((node.is_table() || node.is_array_of_tables()) && !find_parameter(key, scenario_.system)) {
      report(node, key, [this, name = std::string(key)] {
        return unknown_text(kind_text("a table of a scenario"), nearest_group_name(name, scenario_.system));
      });
    } else {
      read_parameter(std::string(key), node);
    }
  }

  void read_group(std::string_view group, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table) {
      report(node, group, [name = std::string(group)] {
        return fmt::format("is a table: write [{}] and its keys on the lines below", name);
      });
      return;
    }
    for (const auto& [key, member] : *table) {
      const std::string name = fmt::format("{}.{}", group, key.str());
      if (const ParameterList* list = find_parameter_list(name, scenario_.system)) {
        read_list(*list, member);
      } else {
        read_parameter(name, member);
      }
    }
  }

  // Replaces the items that the scenario has.
  void read_list(const ParameterList& list, const toml::node& node) {
    if (!node.is_array_of_tables()) {
      report(node, list.name, [name = list.name] {
        return fmt::format("is a list of tables: write [[{}]] and the keys of each on the lines below", name);
      });
      return;
    }
    const toml::array& tables = *node.as_array();
    if (tables.size() > kMostItems) {
      report(node, list.name,
             [size = tables.size()] { return fmt::format("has {} tables; {} are allowed", size, kMostItems); });
      return;
    }
    list.resize(scenario_, 0);
    list.resize(scenario_, tables.size());
    if (!tables.empty()) lines_[std::string(list.name)] = line_of(tables.front());
    for (std::size_t item = 0; item < tables.size(); ++item) {
      lines_[fmt::format("{}.{}", list.name, item)] = line_of(*tables.get(item));
      for (const auto& [key, member] : *tables.get(item)->as_table()) {
        read_parameter(fmt::format("{}.{}.{}", list.name, item, key.str()), member);
      }
    }
  }

  void read_parameter(const std::string& key, const toml::node& node) {
    const Parameter* parameter = find_parameter(key, scenario_);
    if (is_retired_parameter(key)) return;
    if (!parameter) {
      report(node, key, [this, key] {
        return unknown_text(kind_text("a parameter"), nearest_parameter_key(key, scenario_.system));
      });
      return;
    }
    lines_[key] = line_of(node);
    const auto value = parameter_value(*parameter, node);
    if (const auto* problem = std::get_if<ValueProblem>(&value)) {
      report(node, key, [message = problem->message] { return message; });
    } else {
      parameter->set(scenario_, std::get<ParameterValue>(value));
    }
  }

  // For kinds other than the default: "a parameter of the system 'thrown_net'".
  std::string kind_text(std::string_view what) const {
    if (scenario_.system == kPocketSystem) return std::string(what);
    return fmt::format("{} of the system '{}'", what, scenario_.system);
  }

  void report(const toml::node& node, std::string_view key, std::function<std::string()> message) {
    problems_.push_back({line_of(node), std::string(key), std::move(message)});
  }

  static int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

  Scenario& scenario_;
  std::map<std::string, int, std::less<>>& lines_;
  std::vector<Problem> problems_;
};

// The file's text, or one sentence that says why it cannot be read. Reads at most one byte more than allowed, so that
// endless devices do no harm.
std::variant<std::string, Diagnostic> load(const std::string& path) {
  const auto problem = [&path](std::string message) { return Diagnostic{.file = path, .message = std::move(message)}; };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return problem("there is no such file");
  if (std::filesystem::is_directory(status)) return problem("is a folder, not a scenario file");
  std::ifstream file(path, std::ios::binary);
  if (!file) return problem(fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string text(kLargestScenarioFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) return problem("cannot be read: input error");
  if (text.starts_with("\x89HDF\r\n")) {
    return problem("is a recording, not a scenario: see netpocket info, render, plot, report, or run --resume");
  }
  const auto start = std::string_view(text).substr(0, std::min<std::size_t>(file.gcount(), kContentBytes));
  if (const auto other = marked_description(start); !other.empty()) {
    return problem(fmt::format("is {}, not a scenario", other));
  }
  if (file.gcount() > static_cast<std::streamsize>(kLargestScenarioFile)) {
    return problem(fmt::format("is larger than {} bytes, the limit for a scenario", kLargestScenarioFile));
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const auto first = text.find_first_not_of(kBlank);
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// A setting's value as TOML. Adds the quotes of texts and choices, which a shell removes.
std::string setting_text(const Parameter& parameter, std::string_view text) {
  const bool text_like = parameter.type == ParameterType::text || parameter.type == ParameterType::choice;
  return text_like && !text.starts_with('"') && !text.starts_with('\'') ? quoted(text) : std::string(text);
}

Diagnostics single(Diagnostic diagnostic) {
  Diagnostics diagnostics;
  diagnostics.add(std::move(diagnostic));
  return diagnostics;
}

// Like read_scenario_text, with other defaults.
ScenarioResult read_over(Scenario defaults, std::string_view text, const std::string& name) {
  ScenarioResult result{.scenario = std::move(defaults)};
  if (text.size() > kLargestScenarioFile) {
    result.diagnostics =
        single({.file = name,
                .message = fmt::format("is larger than {} bytes, the limit for a scenario", kLargestScenarioFile)});
    return result;
  }
  auto parsed = parse(text);
  if (auto* problem = std::get_if<Diagnostic>(&parsed)) {
    problem->file = name;
    result.diagnostics = single(std::move(*problem));
    return result;
  }
  FileReader reader(result.scenario, result.lines);
  reader.read(std::get<toml::table>(parsed));
  result.diagnostics = reader.diagnostics(name);
  return result;
}

}  // namespace

Diagnostics ScenarioResult::with_lines(const Diagnostics& problems, const std::string& file) const {
  Diagnostics located;
  for (Diagnostic problem : problems.list()) {
    auto found = lines.find(problem.key);
    // The table of an item that does not state the key.
    if (found == lines.end()) found = lines.find(problem.key.substr(0, problem.key.rfind('.')));
    if (found != lines.end() && problem.line == 0) problem.line = found->second;
    if (problem.file.empty()) problem.file = file;
    located.add(std::move(problem));
  }
  return located;
}

ScenarioResult read_scenario_text(std::string_view text, const std::string& name) { return read_over({}, text, name); }

std::string folder_of(const std::string& path) {
  std::error_code error;
  return std::filesystem::absolute(path, error).parent_path().string();
}

ScenarioResult read_scenario_file(const std::string& path) {
  auto loaded = load(path);
  if (auto* problem = std::get_if<Diagnostic>(&loaded)) return {.diagnostics = single(std::move(*problem))};
  Scenario defaults;
  const std::string stem = std::filesystem::path(path).stem().string();
  if (!limit_problem(*find_parameter("name"), stem)) defaults.name = stem;
  defaults.files.folder = folder_of(path);
  return read_over(std::move(defaults), std::get<std::string>(loaded), path);
}

Diagnostics set_parameter(Scenario& scenario, const Parameter& parameter, std::string_view text) {
  const std::string key(parameter.key);
  const auto fails = [&](std::string message) { return single({.key = key, .message = std::move(message)}); };
  const auto not_a_value = [&] {
    return fails(fmt::format("expects {}, not {}", expected_text(parameter), excerpt(text)));
  };
  text = trimmed(text);
  if (text.size() > kLargestScenarioFile) return fails("the value is too long");
  const auto parsed = parse("value = " + setting_text(parameter, text));
  const auto* table = std::get_if<toml::table>(&parsed);
  if (!table || table->size() != 1) return not_a_value();
  const auto value = parameter_value(parameter, *table->get("value"));
  if (const auto* problem = std::get_if<ValueProblem>(&value)) return fails(problem->message);
  parameter.set(scenario, std::get<ParameterValue>(value));
  return {};
}

Diagnostics apply_setting(Scenario& scenario, std::string_view setting) {
  const auto equals = setting.find('=');
  if (equals == setting.npos) {
    return single({.message = fmt::format("a setting is written key=value, not {}", excerpt(setting))});
  }
  const std::string_view key = trimmed(setting.substr(0, equals));
  const Parameter* parameter = find_parameter(key, scenario);
  if (!parameter) {
    const auto nearest = nearest_parameter_key(key, scenario.system);
    if (nearest == key) {
      return single(
          {.message = excerpt(key) + " belongs to a table that the scenario does not have; numbers begin with 0"});
    }
    return single({.message = excerpt(key) + " " + unknown_text("a parameter", nearest)});
  }
  Diagnostics problems = set_parameter(scenario, *parameter, setting.substr(equals + 1));
  if (problems.ok() && key == "target.mesh_file") scenario.files.allows_absolute = true;
  return problems;
}

}  // namespace netpocket
