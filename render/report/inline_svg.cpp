#include "render/report/inline_svg.h"

#include <array>

namespace netpocket {
namespace {

// How an identifier is made and referred to.
constexpr std::array<std::string_view, 3> kBeforeIdentifiers = {" id=\"", "url(#", "href=\"#"};

void put_behind_each(std::string& text, std::string_view place, std::string_view addition) {
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + place.size())) {
    text.insert(at + place.size(), addition);
  }
}

}  // namespace

std::string inline_svg(std::string_view name, std::string_view file) {
  const auto start = file.find("<svg");  // the declaration before it belongs to a file of its own
  if (start == std::string_view::npos) return {};
  std::string svg(file.substr(start));
  for (const auto place : kBeforeIdentifiers) put_behind_each(svg, place, std::string(name) + "-");
  return svg;
}

}  // namespace netpocket
