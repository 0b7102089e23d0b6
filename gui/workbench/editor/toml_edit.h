#pragma once
// Small edits of a scenario's TOML text that leave a person's comments, order and layout as they are.

#include <optional>
#include <string>
#include <string_view>

#include "engine/scenario/parameters.h"

namespace netpocket {

// The text with one parameter set to a value: in place when the text states it, else as a new line in its table. Empty
// when the text cannot be parsed or the key is written in a way that has no place for it (a dotted key, an inline
// table).
std::optional<std::string> with_value(std::string_view text, const Parameter& parameter, const ParameterValue& value);

// Whether the text states the parameter.
bool states(std::string_view text, const Parameter& parameter);

}  // namespace netpocket
