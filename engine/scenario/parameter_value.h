#pragma once
// The value of a parameter of a scenario.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace netpocket {

// In the order of the alternatives of ParameterValue.
enum class ParameterType { number, integer, boolean, text, choice, vector, pairs };

// Value of a parameter with named choices.
struct Choice {
  int index = 0;  // into Parameter::choices
  bool operator==(const Choice&) const = default;
};

using ParameterValue =
    std::variant<double, std::int64_t, bool, std::string, Choice, Eigen::Vector3d, std::vector<Eigen::Vector2d>>;

}  // namespace netpocket
