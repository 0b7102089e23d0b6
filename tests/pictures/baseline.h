#pragma once

#include <string>

namespace netpocket::pictures {

// Expects a picture to look like tests/baselines/NAME.png, after making sure that it is not blank. When it does not, or
// there is no baseline, leaves NAME_actual.png, NAME_baseline.png, NAME_difference.png and all three side by side as
// NAME_comparison.png in the build folder's pictures/baselines/ and says where. With NETPOCKET_RENEW=1 the picture
// becomes the baseline.
void expect_like_baseline(const std::string& picture, const std::string& name);

}  // namespace netpocket::pictures
