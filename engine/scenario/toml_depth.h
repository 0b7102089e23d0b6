#pragma once
// Guards the TOML parser against stack overflow. The parser limits the nesting of values but not that of dotted keys
// (a.a.a.a... = 1).

#include <string_view>

namespace netpocket {

// The first line (1-based) on which a dotted key has more than `limit` dots; 0 when there is none. Strings and comments
// are skipped. Linear in the size of the text.
int line_of_too_deep_key(std::string_view toml, int limit);

}  // namespace netpocket
