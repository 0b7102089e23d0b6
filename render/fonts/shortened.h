#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace netpocket {

// The longest beginning of a text (UTF-8) that fits with an ellipsis behind it; the text itself when that fits.
std::string shortened(std::string_view text, const std::function<bool(const std::string&)>& fits);

}  // namespace netpocket
