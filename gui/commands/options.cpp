#include "gui/commands/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/base/destination.h"
#include "engine/scenario/check_scenario.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/read_scenario.h"
#include "gui/commands/command.h"
#include "gui/commands/spelling.h"

namespace netpocket {
namespace {

// The number that the whole text is, if it is one.
template <typename Number>
std::optional<Number> parse(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char c : list) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

constexpr int kLargestSide = 16384;  // pixels, without supersampling

void require_ok(const Diagnostics& diagnostics, const std::string& file) {
  if (diagnostics.ok()) return;
  Diagnostics named;
  for (Diagnostic diagnostic : diagnostics.list()) {
    if (diagnostic.file.empty()) diagnostic.file = file;
    named.add(std::move(diagnostic));
  }
  throw CommandError(ExitCode::bad_input, named.text());
}

}  // namespace

CLI::Validator one_of(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return {};
    const std::string near = suggestion(text, names);
    return fmt::format("unknown name \"{}\"{}", text,
                       near.empty() ? fmt::format("; use {}", fmt::join(names, ", ")) : near);
  };
  return {check, "", "one_of"};
}

CLI::Option* add_choice(CLI::App& app, const std::string& option, std::string& value, const std::string& help,
                        const std::vector<std::string>& names) {
  return app.add_option(option, value, fmt::format("{}: {}", help, fmt::join(names, ", ")))
      ->type_name("NAME")
      ->check(one_of(names))
      ->capture_default_str();
}

CLI::Validator positive_number() {
  const auto check = [](const std::string& text) -> std::string {
    const auto value = parse<double>(text);
    return value && std::isfinite(*value) && *value > 0 ? "" : fmt::format("\"{}\" is not a number above 0", text);
  };
  return {check, "", "positive_number"};
}

CLI::Validator number_not_below_zero() {
  const auto check = [](const std::string& text) -> std::string {
    const auto value = parse<double>(text);
    return value && std::isfinite(*value) && *value >= 0 ? "" : fmt::format("\"{}\" is not a number from 0", text);
  };
  return {check, "", "number_not_below_zero"};
}

CLI::Validator number_between(double lowest, double highest) {
  const auto check = [=](const std::string& text) -> std::string {
    const auto value = parse<double>(text);
    if (value && *value >= lowest && *value <= highest) return {};
    return fmt::format("\"{}\" is not a number from {:g} to {:g}", text, lowest, highest);
  };
  return {check, "", "number_between"};
}

std::vector<double> numbers_of(const std::string& list) {
  std::vector<double> numbers;
  for (const std::string& part : parts_of(list)) numbers.push_back(parse<double>(part).value_or(NAN));
  return numbers;
}

CLI::Validator list_of_times() {
  const auto check = [](const std::string& text) -> std::string {
    for (const std::string& part : parts_of(text)) {
      if (part.empty()) return fmt::format("\"{}\" has a comma too many", text);
      const auto value = parse<double>(part);
      if (!value || !std::isfinite(*value) || *value < 0) return fmt::format("\"{}\" is not a number from 0", part);
    }
    return {};
  };
  return {check, "", "list_of_times"};
}

CLI::Validator range_of_numbers() {
  const auto check = [](const std::string& text) -> std::string {
    const auto ends = numbers_of(text);
    const bool numbers = ends.size() == 2 && std::isfinite(ends[0]) && std::isfinite(ends[1]);
    if (!numbers) return fmt::format("\"{}\" is not two numbers such as 0,50", text);
    return ends[0] < ends[1] ? "" : "the first value must be below the second";
  };
  return {check, "", "range_of_numbers"};
}

CLI::Validator whole_number(int lowest, int highest) {
  const auto check = [=](const std::string& text) -> std::string {
    const auto value = parse<int>(text);
    if (value && *value >= lowest && *value <= highest) return {};
    return fmt::format("\"{}\" is not a whole number from {} to {}", text, lowest, highest);
  };
  return {check, "", "whole_number"};
}

CLI::Validator allowed_for(std::string_view parameter) {
  const Parameter& limited = *find_parameter(parameter);
  const auto check = [&limited](const std::string& text) -> std::string {
    const auto value = parse<double>(text);
    return value ? limit_problem(limited, *value).value_or("") : fmt::format("\"{}\" is not a number", text);
  };
  return {check, "", "allowed_for"};
}

std::optional<PictureSize> picture_size(const std::string& text) {
  constexpr int kSmallest = 16;
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto width = parse<int>(text.substr(0, cross)), height = parse<int>(text.substr(cross + 1));
  const auto fits = [](const auto& side) { return side && *side >= kSmallest && *side <= kLargestSide; };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return PictureSize{*width, *height};
}

CLI::Validator is_picture_size() {
  const auto check = [](const std::string& text) -> std::string {
    if (picture_size(text)) return {};
    return fmt::format(
        "\"{}\" is not a size such as 1280x720: sides have 16 pixels or more, and {} or less when "
        "multiplied by --supersampling",
        text, kLargestSide);
  };
  return {check, "", "is_picture_size"};
}

CLI::Option* add_scenario_options(CLI::App& app, ScenarioChoice& choice) {
  CLI::Option* scenario =
      app.add_option("SCENARIO", choice.path, "scenario file (TOML); scenarios/REFERENCE.md lists its keys")
          ->required()
          ->type_name("FILE");
  app.add_option("--set", choice.settings, "set a parameter, e.g. closing.duration=5; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  return scenario;
}

Scenario load_scenario(const ScenarioChoice& choice) {
  require_readable(choice.path);
  ScenarioResult result = read_scenario_file(choice.path);
  require_ok(result.diagnostics, choice.path);
  for (const std::string& setting : choice.settings) require_ok(apply_setting(result.scenario, setting), "--set");
  // A setting may be the cause, so lines of the file are named only without settings.
  const Diagnostics problems = check_scenario(result.scenario);
  require_ok(choice.settings.empty() ? result.with_lines(problems, choice.path) : problems, choice.path);
  return std::move(result.scenario);
}

}  // namespace netpocket
