#include "engine/study/uncertain_input.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/scenario/parameters.h"

namespace netpocket {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::string number_text(double value) { return fmt::format("{:.12g}", value); }

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x(), v.y(), v.z());
}

// Multiplies the number, or all numbers, of a setting's place in a scenario.
std::string scaled_text(const std::string& key, double factor, const Scenario& nominal) {
  const auto number = number_of(nominal, key);
  if (number) return number_text(factor * *number);
  const Parameter* parameter = find_parameter(key, nominal);
  return vector_text(factor * std::get<Eigen::Vector3d>(parameter->get(nominal)));
}

std::string drawn_text(const UncertainNumber& input, double fraction, const Scenario& nominal) {
  const double value = quantile(input.distribution, fraction);
  if (!input.choices.empty()) return input.choices[static_cast<std::size_t>(value)];
  if (input.is_relative) return scaled_text(input.key, value, nominal);
  const Parameter* parameter = find_parameter(input.key, nominal);
  const bool is_whole = parameter && parameter->type == ParameterType::integer;
  return is_whole ? fmt::format("{}", std::llround(value)) : number_text(value);
}

}  // namespace

int coordinate_count(const UncertainInput& input) {
  return std::visit(Overloaded{[](const UncertainNumber&) { return 1; }, [](const UncertainDirection&) { return 3; },
                               [](const CorrelatedInputs& group) { return static_cast<int>(group.keys.size()); }},
                    input);
}

int coordinate_count(const std::vector<UncertainInput>& inputs) {
  int count = 0;
  for (const UncertainInput& input : inputs) count += coordinate_count(input);
  return count;
}

std::vector<std::string> keys_of(const UncertainInput& input) {
  return std::visit(Overloaded{[](const UncertainNumber& number) { return std::vector{number.key}; },
                               [](const UncertainDirection& direction) { return std::vector{direction.key}; },
                               [](const CorrelatedInputs& group) { return group.keys; }},
                    input);
}

std::vector<Setting> drawn_settings(const UncertainInput& input, std::span<const double> fractions,
                                    const Scenario& nominal) {
  const auto number = [&](const UncertainNumber& in) {
    return std::vector<Setting>{{in.key, drawn_text(in, fractions[0], nominal)}};
  };
  const auto along = [&](const UncertainDirection& in) {
    const Eigen::Vector3d vector = quantile(in.size, fractions[2]) * direction(fractions[0], fractions[1]);
    return std::vector<Setting>{{in.key, vector_text(vector)}};
  };
  const auto group = [&](const CorrelatedInputs& in) {
    const Eigen::Map<const Eigen::VectorXd> point(fractions.data(), static_cast<Eigen::Index>(in.keys.size()));
    const Eigen::VectorXd values = correlated_values(in.normals, point);
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < in.keys.size(); ++i) {
      settings.push_back({in.keys[i], number_text(values[static_cast<Eigen::Index>(i)])});
    }
    return settings;
  };
  return std::visit(Overloaded{number, along, group}, input);
}

}  // namespace netpocket
