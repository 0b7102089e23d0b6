#pragma once
// Generates the reference of all parameters, scenarios/REFERENCE.md, from the parameter table.

#include <string>

namespace netpocket {

// Markdown: a table per group.
std::string parameter_reference();

}  // namespace netpocket
