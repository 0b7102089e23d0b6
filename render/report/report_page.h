#pragma once
// The page itself, from what it holds.

#include <string>
#include <vector>

#include "engine/recording/recording.h"

namespace netpocket {

struct ReportMedia {
  std::string sheet;                                         // PNG
  std::string video;                                         // MP4; empty: none
  std::vector<std::pair<std::string, std::string>> figures;  // name and SVG
};

// A complete HTML document that loads nothing from elsewhere.
std::string report_page(const std::vector<const Recording*>& recordings, const ReportMedia& media);

}  // namespace netpocket
