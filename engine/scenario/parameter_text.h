#pragma once
// Parameters and their values as text, for files, messages, forms and the reference.

#include <optional>
#include <string>
#include <string_view>

#include "engine/scenario/parameters.h"

namespace netpocket {

// A value in TOML syntax. Numbers have the fewest digits that read back as the same double.
std::string toml_text(const Parameter& parameter, const ParameterValue& value);

// A text in quotes. All characters that could break a line or a terminal are escaped.
std::string quoted(std::string_view text);

// Kind of value that a parameter takes: "a number in m", "one of \"free\", \"attitude\"".
std::string expected_text(const Parameter& parameter);

// Range that the limits allow, without the unit: ">= 0 and <= 1". Empty when there are no limits.
std::string allowed_text(const Parameter& parameter);

// Why a value of the right type is not allowed, in one sentence; nothing when it is allowed.
std::optional<std::string> limit_problem(const Parameter& parameter, const ParameterValue& value);

}  // namespace netpocket
