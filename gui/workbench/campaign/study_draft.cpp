#include "gui/workbench/campaign/study_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/parameters.h"
#include "engine/study/setting.h"

namespace netpocket {
namespace {

constexpr double kUsualOffset = 0.5;     // m
constexpr double kUsualDeviation = 0.1;  // of the value, or in units where that is 0

const Parameter* parameter_of(const Scenario& scenario, const std::string& key) {
  return find_parameter(key.substr(0, key.find('[')), scenario);
}

bool is_whole_vector(const Scenario& scenario, const std::string& key) {
  const Parameter* parameter = find_parameter(key, scenario);
  return parameter != nullptr && parameter->type == ParameterType::vector;
}

// Twelve digits hide what binary fractions add.
std::string digits(double value) { return fmt::format("{:.12g}", value); }

std::string distribution_text(const DraftInput& input, const Scenario& scenario) {
  const double centre = number_of(scenario, input.key).value_or(0);
  switch (input.scatter) {
    case Scatter::uniform:
      return fmt::format("{{ distribution = \"uniform\", min = {}, max = {} }}", digits(centre - input.spread),
                         digits(centre + input.spread));
    case Scatter::normal:
      return fmt::format("{{ distribution = \"normal\", mean = {}, deviation = {} }}", digits(centre),
                         digits(input.spread));
    case Scatter::factor:
      return fmt::format("{{ distribution = \"log_normal\", median = 1, log_deviation = {}, relative = true }}",
                         digits(input.spread));
    case Scatter::direction:
      break;
  }
  return fmt::format("{{ distribution = \"direction\", size = {{ distribution = \"uniform\", min = 0, max = {} }} }}",
                     digits(input.spread));
}

// Vectors' numbers need quotes.
std::string key_text(const std::string& key) { return key.find('[') == key.npos ? key : fmt::format("\"{}\"", key); }

std::string unit_note(const DraftInput& input, const Scenario& scenario) {
  const Parameter* parameter = parameter_of(scenario, input.key);
  const bool has_unit = parameter != nullptr && !parameter->unit.empty() && input.scatter != Scatter::factor;
  return has_unit ? fmt::format("   # {}", parameter->unit) : "";
}

// Of two inputs that set the same number.
bool overlap(const std::string& a, const std::string& b) {
  return a == b || a.substr(0, a.find('[')) == b || b.substr(0, b.find('[')) == a;
}

}  // namespace

std::string study_text(const StudyDraft& draft, const Scenario& scenario) {
  std::string text =
      fmt::format("base = {}\nsampling = {}\nsamples = {}\nseed = {}\n\n[uncertain]\n", netpocket::quoted(draft.base),
                  netpocket::quoted(draft.sampling), draft.samples, draft.seed);
  for (const DraftInput& input : draft.inputs) {
    text +=
        fmt::format("{} = {}{}\n", key_text(input.key), distribution_text(input, scenario), unit_note(input, scenario));
  }
  if (!draft.estimate.empty()) {
    std::vector<std::string> names;
    for (const std::string& column : draft.estimate) names.push_back(netpocket::quoted(column));
    text += fmt::format("\n[estimate]\nof = [{}]\n", fmt::join(names, ", "));
  }
  if (draft.half_width) text += fmt::format("\n[until]\nhalf_width = {}\n", digits(*draft.half_width));
  return text;
}

std::optional<std::string> draft_problem(const StudyDraft& draft, const Scenario& scenario) {
  if (draft.inputs.empty()) return "Nothing is uncertain: add an input.";
  for (std::size_t i = 0; i < draft.inputs.size(); ++i) {
    const DraftInput& input = draft.inputs[i];
    if (parameter_of(scenario, input.key) == nullptr) {
      return fmt::format("{} is no parameter of this scenario: remove it.", input.key);
    }
    if (!(input.spread > 0)) return fmt::format("{} needs a spread above 0.", input.key);
    for (std::size_t j = 0; j < i; ++j) {
      if (overlap(input.key, draft.inputs[j].key)) {
        return fmt::format("{} is there twice: remove one.", draft.inputs[j].key);
      }
    }
  }
  return std::nullopt;
}

std::vector<std::string> scatter_keys(const Scenario& scenario) {
  std::vector<std::string> keys;
  for (const Parameter* parameter : parameters_of(scenario)) {
    const bool is_output = parameter->group() == "output" || parameter->group() == "solver";
    if (is_output) continue;
    const std::string key(parameter->key);
    if (parameter->type == ParameterType::number) keys.push_back(key);
    if (parameter->type != ParameterType::vector) continue;
    keys.push_back(key);
    for (int i = 0; i < 3; ++i) keys.push_back(fmt::format("{}[{}]", key, i));
  }
  return keys;
}

std::vector<Scatter> possible_scatters(const Scenario& scenario, const std::string& key) {
  if (is_whole_vector(scenario, key)) return {Scatter::direction, Scatter::factor};
  const double value = number_of(scenario, key).value_or(0);
  if (value == 0) return {Scatter::uniform, Scatter::normal};
  return {Scatter::uniform, Scatter::normal, Scatter::factor};
}

double usual_spread(const Scenario& scenario, const std::string& key) {
  const double value = std::abs(number_of(scenario, key).value_or(0));
  if (value == 0) return kUsualDeviation;
  // Three digits are enough for a guess.
  return std::stod(fmt::format("{:.3g}", kUsualDeviation * value));
}

StudyDraft usual_draft(const Scenario& scenario) {
  StudyDraft draft;
  draft.estimate = {"smallest_gap", "escape_depth"};
  for (const char* key : {"target.position[0]", "target.position[2]"}) {
    if (number_of(scenario, key)) draft.inputs.push_back({key, Scatter::uniform, kUsualOffset});
  }
  for (const char* key : {"target.mass", "contact.friction"}) {
    const double spread = usual_spread(scenario, key);
    if (number_of(scenario, key).value_or(0) > 0) draft.inputs.push_back({key, Scatter::normal, spread});
  }
  return draft;
}

}  // namespace netpocket
