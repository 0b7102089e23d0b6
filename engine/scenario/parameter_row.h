#pragma once
// Makes rows of the parameter table from members of Scenario. Internal to this room.

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "engine/scenario/parameters.h"

namespace netpocket::parameter_rows {

// Names of an enum's values, in their order.
template <typename Enum>
constexpr std::array<std::string_view, 0> kNames{};

// Alternative of ParameterValue that stores a member of type T.
template <typename T>
using Stored =
    std::conditional_t<std::is_enum_v<T>, Choice, std::conditional_t<std::is_same_v<T, int>, std::int64_t, T>>;

// Index of a type among a variant's alternatives.
template <typename T, typename... Alternatives>
constexpr std::size_t position(std::type_identity<std::variant<Alternatives...>>) {
  constexpr std::array same = {std::is_same_v<T, Alternatives>...};
  return std::find(same.begin(), same.end(), true) - same.begin();
}

// Member reached through a path of pointers to members.
template <auto... Path, typename S>
constexpr auto& member(S& scenario) {
  return (scenario.*....*Path);
}

template <typename T>
ParameterValue to_value(const T& member) {
  if constexpr (std::is_enum_v<T>) {
    return Choice{static_cast<int>(member)};
  } else {
    return static_cast<Stored<T>>(member);
  }
}

template <typename T>
void assign(T& member, const ParameterValue& value) {
  const auto& stored = std::get<Stored<T>>(value);
  if constexpr (std::is_enum_v<T>) {
    member = static_cast<T>(stored.index);
  } else {
    member = static_cast<T>(stored);
  }
}

template <auto... Path>
constexpr Parameter parameter(std::string_view key, Limits limits, std::string_view unit, std::string_view help,
                              std::string_view source) {
  using T = std::remove_cvref_t<decltype(member<Path...>(std::declval<Scenario&>()))>;
  return {.key = key,
          .type = ParameterType{position<Stored<T>>(std::type_identity<ParameterValue>{})},
          .limits = limits,
          .unit = unit,
          .help = help,
          .source = source,
          .choices = kNames<T>,
          .read = [](const Scenario& scenario, const Parameter&) { return to_value(member<Path...>(scenario)); },
          .write = [](Scenario& scenario, const Parameter&,
                      const ParameterValue& value) { assign(member<Path...>(scenario), value); }};
}

// A row of a list, for the item Parameter::item. `List`: the member of Scenario; `Member`: of its items.
template <auto List, auto Member>
constexpr Parameter item_parameter(std::string_view key, Limits limits, std::string_view unit, std::string_view help,
                                   std::string_view source) {
  using Item = typename std::remove_cvref_t<decltype(std::declval<Scenario&>().*List)>::value_type;
  using T = std::remove_cvref_t<decltype(std::declval<Item&>().*Member)>;
  return {.key = key,
          .type = ParameterType{position<Stored<T>>(std::type_identity<ParameterValue>{})},
          .limits = limits,
          .unit = unit,
          .help = help,
          .source = source,
          .choices = kNames<T>,
          .read = [](const Scenario& scenario,
                     const Parameter& row) { return to_value((scenario.*List).at(row.item).*Member); },
          .write = [](Scenario& scenario, const Parameter& row,
                      const ParameterValue& value) { assign((scenario.*List).at(row.item).*Member, value); }};
}

constexpr Limits within(double minimum, double maximum) { return {minimum, maximum}; }
constexpr Limits above(double minimum, double maximum) { return {minimum, maximum, true}; }
inline constexpr Limits kNone{};

// Sources.
inline constexpr std::string_view kAssumption = "assumption";
inline constexpr std::string_view kChoice = "user's choice";

}  // namespace netpocket::parameter_rows
