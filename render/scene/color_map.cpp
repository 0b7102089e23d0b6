#include "render/scene/color_map.h"

#include <fmt/format.h>

#include <cstdint>
#include <span>

#include "render/render_error.h"

namespace netpocket {
namespace {

// Evenly spaced samples of the maps of matplotlib (S. van der Walt, N. Smith, E. Firing; cividis: J. Nunez, C.
// Anderton, R. Renslow, doi:10.1371/journal.pone.0199239), all in the public domain.
constexpr std::array<std::uint32_t, 10> kViridis = {0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E,
                                                    0x1F9E89, 0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725};
constexpr std::array<std::uint32_t, 12> kCividis = {0x00204D, 0x00306F, 0x2A406C, 0x48526B, 0x5E626E, 0x727374,
                                                    0x878479, 0x9E9677, 0xB6A971, 0xD0BE67, 0xEAD357, 0xFFEA46};
constexpr std::array<std::uint32_t, 10> kPlasma = {0x0D0887, 0x47039F, 0x7301A8, 0x9C179E, 0xBD3786,
                                                   0xD8576B, 0xED7953, 0xFA9E3B, 0xFDC926, 0xF0F921};

Color from_hex(std::uint32_t hex) { return {(hex >> 16) / 255.0, (hex >> 8 & 0xFF) / 255.0, (hex & 0xFF) / 255.0}; }

std::span<const std::uint32_t> samples_of(ColorMap map) {
  switch (map) {
    case ColorMap::cividis:
      return kCividis;
    case ColorMap::plasma:
      return kPlasma;
    case ColorMap::viridis:
      break;
  }
  return kViridis;
}

}  // namespace

Color map_color(ColorMap map, double fraction) {
  const auto samples = samples_of(map);
  const double last = static_cast<double>(samples.size() - 1);
  const double place = fraction > 0 ? std::min(fraction, 1.0) * last : 0;
  const auto lower = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
  return mix(from_hex(samples[lower]), from_hex(samples[lower + 1]), place - static_cast<double>(lower));
}

ColorMap color_map_from_name(std::string_view name) {
  if (name == "viridis") return ColorMap::viridis;
  if (name == "cividis") return ColorMap::cividis;
  if (name == "plasma") return ColorMap::plasma;
  throw RenderError(fmt::format("unknown colour map '{}': use viridis, cividis or plasma", name));
}

}  // namespace netpocket
