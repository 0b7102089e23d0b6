#pragma once
// Which netpocket this is.

#include <string>

namespace netpocket {

const char* program_version();  // "0.2.0"
const char* program_commit();   // as `git describe` names it; "unknown" outside a clone

// Several lines: version, commit, and the versions of the libraries that results and pictures depend on.
std::string version_text();

}  // namespace netpocket
