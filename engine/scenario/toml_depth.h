#pragma once
// Guards the TOML parser, which limits the nesting of values but not that of dotted keys (a.a.a.a... = 1) and would
// overflow the stack.

#include <string_view>

namespace netpocket {

// The 1-based line on which a dotted key has more than `limit` dots; 0 when there is none. Strings and comments do not
// count. Linear in the size of the text.
int line_of_too_deep_key(std::string_view toml, int limit);

}  // namespace netpocket
