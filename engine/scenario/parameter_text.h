#pragma once
// Parameters and their values as text: for files, messages, forms and the reference.

#include <optional>
#include <string>
#include <string_view>

#include "engine/scenario/parameters.h"

namespace netpocket {

// A value as TOML writes it. Numbers have the fewest digits that read back as the same double.
std::string toml_text(const Parameter& parameter, const ParameterValue& value);

// A text in quotes, with everything escaped that could break a line or a terminal.
std::string quoted(std::string_view text);

// What kind of value a parameter takes: "a number in m", "one of \"free\", \"attitude\"".
std::string expected_text(const Parameter& parameter);

// What the limits allow, without the unit: ">= 0 and <= 1". Empty when there are none.
std::string allowed_text(const Parameter& parameter);

// Why a value of the right type is not allowed, in one sentence; empty when it is allowed.
std::optional<std::string> limit_problem(const Parameter& parameter, const ParameterValue& value);

}  // namespace netpocket
