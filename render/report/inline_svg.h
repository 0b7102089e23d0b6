#pragma once

#include <string>
#include <string_view>

namespace netpocket {

// An SVG file as a part of an HTML page, where its text can be searched. `name` (letters, digits, '_') tells the page's
// drawings apart: it is put before each identifier in it. Empty when the file has no drawing.
std::string inline_svg(std::string_view name, std::string_view file);

}  // namespace netpocket
