#include "render/scene/color_scale.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace netpocket {
namespace {

// On white, the bright end of a map would not be seen as a thin line; on black, neither would the dark end.
ColorMap default_map(Background background) {
  return background == Background::white ? ColorMap::plasma : ColorMap::viridis;
}
// Sum of the sizes of the forces of each element's contacts, N.
std::vector<double> contact_forces(const Structure& structure, const Snapshot& snapshot) {
  std::vector<double> forces(structure.elements.size());
  for (const auto& contact : snapshot.contacts) {
    const auto element = static_cast<std::size_t>(contact.element);
    if (contact.element >= 0 && element < forces.size()) forces[element] += contact.force.norm();
  }
  return forces;
}

ValueRange visible_part(Background background) {
  return background == Background::white ? ValueRange{0, 0.82} : ValueRange{0.34, 1};
}

}  // namespace

ColorScale::ColorScale(const Structure& structure, const SceneOptions& options)
    : structure_(structure),
      color_by_(options.color_by),
      map_(options.color_map.value_or(default_map(options.background))),
      map_part_(visible_part(options.background)),
      fixed_range_(options.color_range.has_value()),
      range_(options.color_range.value_or(ValueRange{0, 0})) {}

// Rods are compressed while cords are taut: on one scale neither would show anything.
bool ColorScale::colors(CableLook look) const {
  if (color_by_ == ColorBy::speed || color_by_ == ColorBy::contact) return true;
  return active() && look != CableLook::tube;
}

double ColorScale::value(const Snapshot& snapshot, std::size_t element, double fraction) const {
  const auto index = static_cast<Eigen::Index>(element);
  switch (color_by_) {
    case ColorBy::tension:
      return snapshot.tension[index];
    case ColorBy::strain:
      return snapshot.strain[index];
    case ColorBy::speed: {
      const auto& nodes = structure_.elements[element].node;
      return (1 - fraction) * snapshot.velocities.col(nodes[0]).norm() +
             fraction * snapshot.velocities.col(nodes[1]).norm();
    }
    case ColorBy::contact:
      return contact_[element];
    case ColorBy::none:
      break;
  }
  return 0;
}

Color ColorScale::color(double value) const {
  const double width = range_.high - range_.low;
  return color_at_fraction(width > 0 ? (value - range_.low) / width : 0);
}

Color ColorScale::color_at_fraction(double fraction) const {
  const double clamped = fraction > 0 ? std::min(fraction, 1.0) : 0;
  return map_color(map_, map_part_.low + clamped * (map_part_.high - map_part_.low));
}

void ColorScale::update(const Snapshot& snapshot) {
  if (color_by_ == ColorBy::contact) contact_ = contact_forces(structure_, snapshot);
  if (fixed_range_ || !active()) return;
  const double high = high_value(structure_, snapshot, color_by_);
  if (high > range_.high || range_.high == 0) range_.high = round_up(high);
}

std::string color_label(ColorBy color_by) {
  switch (color_by) {
    case ColorBy::tension:
      return "tension, N";
    case ColorBy::strain:
      return "strain, \u00b5m/m";
    case ColorBy::speed:
      return "speed, m/s";
    case ColorBy::contact:
      return "contact force, N";
    case ColorBy::none:
      break;
  }
  return {};
}

double ColorScale::display_unit() const { return color_by_ == ColorBy::strain ? 1e-6 : 1; }

double high_value(const Structure& structure, const Snapshot& snapshot, ColorBy color_by) {
  SceneOptions options;
  options.color_by = color_by;
  options.color_range = ValueRange{};
  ColorScale scale(structure, options);
  scale.update(snapshot);
  std::vector<double> values;
  for (std::size_t i = 0; i < structure.elements.size(); ++i) {
    if (!scale.colors(structure.look_of(structure.elements[i]))) continue;
    values.push_back(std::max(scale.value(snapshot, i, 0), scale.value(snapshot, i, 1)));
  }
  if (color_by == ColorBy::contact) std::erase(values, 0);
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

double round_up(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 2.5, 5.0}) {
    if (value <= step * decade * (1 + 1e-9)) return step * decade;
  }
  return 10 * decade;
}

}  // namespace netpocket
