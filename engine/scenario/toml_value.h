#pragma once
// From TOML's values to those of parameters.

#include <toml++/toml.h>

#include <string>
#include <variant>

#include "engine/scenario/parameters.h"

namespace netpocket {

// Why a TOML value is not one for a parameter.
struct ValueProblem {
  std::string message;  // one sentence without subject: "expects a number in m, not the text \"4 mm\""
};

// The parameter's value, of its type and within its limits, or what is wrong.
std::variant<ParameterValue, ValueProblem> parameter_value(const Parameter& parameter, const toml::node& node);

// A text of a user's file in quotes, shortened so that it fits into a message.
std::string excerpt(std::string_view text);

}  // namespace netpocket
