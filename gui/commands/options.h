#pragma once
// What several commands share: checks of option values, and the scenario.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/scenario/scenario.h"

namespace netpocket {

// Checks for CLI::Option::check; each refuses with a sentence that says what is allowed.
CLI::Validator positive_number();
CLI::Validator number_not_below_zero();
CLI::Validator number_between(double lowest, double highest);
CLI::Validator whole_number(int lowest, int highest);
// A number within the limits of a parameter.
CLI::Validator allowed_for(std::string_view parameter);

// Numbers between commas, such as "0,2.5,5". The check refuses parts that are empty or no numbers from 0.
std::vector<double> numbers_of(const std::string& list);
CLI::Validator list_of_times();

// "LOW,HIGH", the first below the second.
CLI::Validator range_of_numbers();

// Pictures per second.
inline constexpr double kLowestRate = 0.001, kHighestRate = 1000;

// "1280x720", each side 16 to 16384 before supersampling.
struct PictureSize {
  int width = 0;   // pixels
  int height = 0;  // pixels
};
std::optional<PictureSize> picture_size(const std::string& text);
CLI::Validator is_picture_size();

// Adds an option that takes one of some names; for any other the nearest is suggested.
CLI::Option* add_choice(CLI::App& app, const std::string& option, std::string& value, const std::string& help,
                        const std::vector<std::string>& names);
CLI::Validator one_of(const std::vector<std::string>& names);

// Adds the positional SCENARIO and the option --set.
struct ScenarioChoice {
  std::string path;
  std::vector<std::string> settings;  // "key=value"
};
// Returns the positional option.
CLI::Option* add_scenario_options(CLI::App& app, ScenarioChoice& choice);

// Reads, applies the settings, then checks. Throws CommandError(bad_input) with all problems.
Scenario load_scenario(const ScenarioChoice& choice);

}  // namespace netpocket
