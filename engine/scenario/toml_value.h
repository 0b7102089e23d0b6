#pragma once
// Converts TOML values to parameter values.

#include <toml++/toml.h>

#include <string>
#include <variant>

#include "engine/scenario/parameters.h"

namespace netpocket {

// Why a TOML value does not suit a parameter.
struct ValueProblem {
  std::string message;  // one sentence without its subject: "expects a number in m, not the text \"4 mm\""
};

// The value with the parameter's type and within its limits, or what is wrong.
std::variant<ParameterValue, ValueProblem> parameter_value(const Parameter& parameter, const toml::node& node);

// Text from a user's file, in quotes and shortened to fit into a message.
std::string excerpt(std::string_view text);

}  // namespace netpocket
