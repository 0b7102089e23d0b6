#pragma once
// Pieces of an HTML page.

#include <string>
#include <string_view>

namespace netpocket {

// Text with the characters that mean something in HTML written as entities; what is not UTF-8 becomes U+FFFD.
std::string html_text(std::string_view text);

// The content of a file inside a page, as the value of a src attribute.
std::string data_url(std::string_view media_type, std::string_view bytes);

}  // namespace netpocket
