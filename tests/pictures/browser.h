#pragma once
// Opens pages in Chromium, without a window and without a network.

#include <optional>
#include <string>

namespace netpocket::pictures {

// The page's document after it has loaded and its scripts have run; a picture of it, `width` x `height` pixels, is
// written to `picture`. None when Chromium is not installed.
std::optional<std::string> open_in_browser(const std::string& page, const std::string& picture, int width, int height);

}  // namespace netpocket::pictures
