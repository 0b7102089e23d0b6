#include "engine/scenario/parameter_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace netpocket {
namespace {

template <typename... Lambdas>
struct Overloaded : Lambdas... {
  using Lambdas::operator()...;
};
template <typename... Lambdas>
Overloaded(Lambdas...) -> Overloaded<Lambdas...>;  // Clang 14 cannot deduce it

// Fewest digits that read back as the same double. Writes 12e9 for 12000000000 and 1e-5 for 1e-05.
std::string number_text(double number) {
  std::string text = fmt::format("{}", number);
  if (const auto zero = text.find("e-0"); zero != text.npos) text.erase(zero + 2, 1);
  const auto zeros = text.size() - (text.find_last_not_of('0') + 1);
  constexpr std::size_t kManyZeros = 6;
  if (zeros < kManyZeros || text.find_first_of(".en") != text.npos) return text;
  const auto exponent = zeros - zeros % 3;
  return fmt::format("{}e{}", text.substr(0, text.size() - exponent), exponent);
}

std::string list_text(const auto& numbers) {
  std::vector<std::string> texts;
  for (const double number : numbers) texts.push_back(number_text(number));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

std::string in_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : fmt::format("{} in {}", text, unit);
}

std::size_t character_count(std::string_view utf8) {
  return std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; });
}

// First number of a value that is outside the limits.
std::optional<double> outlier(const Limits& limits, const ParameterValue& value) {
  const auto in = [&limits](const auto& numbers) -> std::optional<double> {
    for (const double number : numbers) {
      if (!limits.contain(number)) return number;
    }
    return std::nullopt;
  };
  return std::visit(Overloaded{[&](double number) { return in(std::array{number}); },
                               [&](std::int64_t number) { return in(std::array{static_cast<double>(number)}); },
                               [&](const Eigen::Vector3d& vector) { return in(vector); },
                               [&](const std::vector<Eigen::Vector2d>& pairs) {
                                 std::optional<double> found;
                                 for (const auto& pair : pairs) {
                                   if (!found) found = in(pair);
                                 }
                                 return found;
                               },
                               [](const auto&) { return std::optional<double>(); }},
                    value);
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (c == '\n') {
      result += "\\n";
    } else if (byte < 0x20 || byte == 0x7f) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string toml_text(const Parameter& parameter, const ParameterValue& value) {
  return std::visit(Overloaded{[](bool flag) { return std::string(flag ? "true" : "false"); },
                               [](const std::string& text) { return netpocket::quoted(text); },
                               [&](Choice choice) { return quoted(parameter.choices[choice.index]); },
                               [](const Eigen::Vector3d& vector) { return list_text(vector); },
                               [](const std::vector<Eigen::Vector2d>& pairs) {
                                 std::vector<std::string> texts;
                                 for (const auto& pair : pairs) texts.push_back(list_text(pair));
                                 return fmt::format("[{}]", fmt::join(texts, ", "));
                               },
                               [](std::int64_t number) { return fmt::format("{}", number); },
                               [](double number) { return number_text(number); }},
                    value);
}

std::string expected_text(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::number:
      return in_unit("a number", parameter.unit);
    case ParameterType::integer:
      return in_unit("a whole number", parameter.unit);
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::text:
      return "text in quotes";
    case ParameterType::choice: {
      std::vector<std::string> names;
      for (const std::string_view name : parameter.choices) names.push_back(quoted(name));
      return fmt::format("one of {}", fmt::join(names, ", "));
    }
    case ParameterType::vector:
      return in_unit("a list of three numbers [x, y, z]", parameter.unit);
    case ParameterType::pairs:
      return in_unit("a list of pairs of numbers [[a, b], ...]", parameter.unit);
  }
  return {};
}

std::string allowed_text(const Parameter& parameter) {
  const Limits& limits = parameter.limits;
  if (parameter.type == ParameterType::boolean || parameter.type == ParameterType::choice) return {};
  if (parameter.type == ParameterType::text) return fmt::format("{} to {} characters", limits.minimum, limits.maximum);
  return fmt::format("{} {} and <= {}", limits.minimum_excluded ? ">" : ">=", number_text(limits.minimum),
                     number_text(limits.maximum));
}

std::optional<std::string> limit_problem(const Parameter& parameter, const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    const std::size_t length = character_count(*text);
    if (parameter.limits.contain(static_cast<double>(length))) return std::nullopt;
    return fmt::format("has {} characters, allowed are {}", length, allowed_text(parameter));
  }
  const std::optional<double> number = outlier(parameter.limits, value);
  if (!number) return std::nullopt;
  if (!std::isfinite(*number)) return fmt::format("must be finite, not {}", *number);
  const bool pairs = parameter.type == ParameterType::pairs;
  const bool several = pairs || parameter.type == ParameterType::vector;
  // Pairs have a unit per column, so no unit fits both numbers.
  const std::string allowed = pairs ? allowed_text(parameter) : with_unit(allowed_text(parameter), parameter.unit);
  return fmt::format("{}must be {}, not {}", several ? "each number " : "", allowed, number_text(*number));
}

}  // namespace netpocket
