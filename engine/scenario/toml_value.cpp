#include "engine/scenario/toml_value.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/scenario/parameter_text.h"

namespace netpocket {
namespace {

// The numbers of a list of exactly `Size` numbers.
template <int Size>
std::optional<Eigen::Vector<double, Size>> numbers(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list || list->size() != Size) return std::nullopt;
  Eigen::Vector<double, Size> result;
  for (int i = 0; i < Size; ++i) {
    const toml::node& element = *list->get(i);
    if (!element.is_number()) return std::nullopt;
    result[i] = *element.value<double>();
  }
  return result;
}

// Description of a node, for "expects ..., not ...".
std::string found_text(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "the text " + excerpt(node.ref<std::string>());
    case toml::node_type::integer:
      return fmt::format("{}", node.ref<std::int64_t>());
    case toml::node_type::floating_point:
      return fmt::format("{}", node.ref<double>());
    case toml::node_type::boolean:
      return node.ref<bool>() ? "true" : "false";
    case toml::node_type::array:
      return fmt::format("a list of {}", node.as_array()->size());
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

// The first element that is not a number, as "one with ... in it"; nothing when all are numbers.
std::optional<std::string> stranger(const toml::array& list) {
  for (const toml::node& element : list) {
    if (!element.is_number()) return fmt::format("one with {} in it", found_text(element));
  }
  return std::nullopt;
}

// Like found_text. For a list of the right size, describes the element that is wrong.
std::string found_instead(const Parameter& parameter, const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list && parameter.type == ParameterType::vector && list->size() == 3) {
    return stranger(*list).value_or(found_text(node));
  }
  if (list && parameter.type == ParameterType::pairs) {
    for (const toml::node& element : *list) {
      const toml::array* pair = element.as_array();
      if (!pair) break;
      if (pair->size() != 2) return fmt::format("one with {} in it", found_text(element));
      if (const auto found = stranger(*pair)) return *found;
    }
  }
  return found_text(node);
}

std::optional<std::vector<Eigen::Vector2d>> pairs(const toml::node& node) {
  if (!node.is_array()) return std::nullopt;
  std::vector<Eigen::Vector2d> result;
  for (const toml::node& element : *node.as_array()) {
    const auto pair = numbers<2>(element);
    if (!pair) return std::nullopt;
    result.push_back(*pair);
  }
  return result;
}

std::optional<Choice> choice(const Parameter& parameter, const toml::node& node) {
  const auto name = node.value_exact<std::string_view>();
  for (std::size_t i = 0; name && i < parameter.choices.size(); ++i) {
    if (parameter.choices[i] == *name) return Choice{static_cast<int>(i)};
  }
  return std::nullopt;
}

template <typename T>
std::optional<ParameterValue> widen(std::optional<T> value) {
  if (!value) return std::nullopt;
  return ParameterValue(std::move(*value));
}

// Accepts 8.0 as a whole number.
std::optional<std::int64_t> whole_number(const toml::node& node) {
  const auto number = node.value_exact<double>();
  constexpr double kLargest = 9007199254740992.0;  // up to which a double represents every whole number
  if (number && std::abs(*number) <= kLargest && *number == std::trunc(*number)) {
    return static_cast<std::int64_t>(*number);
  }
  return node.value_exact<std::int64_t>();
}

// The value, if the node has the parameter's type. Whole numbers are accepted as numbers.
std::optional<ParameterValue> typed_value(const Parameter& parameter, const toml::node& node) {
  switch (parameter.type) {
    case ParameterType::number:
      return node.is_number() ? widen(node.value<double>()) : std::nullopt;
    case ParameterType::integer:
      return widen(whole_number(node));
    case ParameterType::boolean:
      return widen(node.value_exact<bool>());
    case ParameterType::text:
      return widen(node.value_exact<std::string>());
    case ParameterType::choice:
      return widen(choice(parameter, node));
    case ParameterType::vector:
      return widen(numbers<3>(node));
    case ParameterType::pairs:
      return widen(pairs(node));
  }
  return std::nullopt;
}

std::string suggestion(const Parameter& parameter, const toml::node& node) {
  const auto text = node.value_exact<std::string_view>();
  const auto name = text ? nearest_choice(parameter, *text) : std::nullopt;
  return name ? fmt::format("; did you mean {}?", quoted(*name)) : "";
}

}  // namespace

std::string excerpt(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return quoted(text);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a UTF-8 character
  return netpocket::quoted(std::string(text.substr(0, end)) + "...");
}

std::variant<ParameterValue, ValueProblem> parameter_value(const Parameter& parameter, const toml::node& node) {
  std::optional<ParameterValue> value = typed_value(parameter, node);
  if (!value) {
    return ValueProblem{fmt::format("expects {}, not {}{}", expected_text(parameter), found_instead(parameter, node),
                                    suggestion(parameter, node))};
  }
  if (auto problem = limit_problem(parameter, *value)) return ValueProblem{std::move(*problem)};
  return std::move(*value);
}

}  // namespace netpocket
