#pragma once
// From a value on an element to a colour: which quantity, its range, its colour map.

#include <string>
#include <vector>

#include "engine/state/snapshot.h"
#include "engine/state/structure.h"
#include "render/scene/scene_options.h"

namespace netpocket {

// Quantity and unit, e.g. "tension, N"; empty for ColorBy::none.
std::string color_label(ColorBy color_by);

class ColorScale {
 public:
  ColorScale(const Structure& structure, const SceneOptions& options);

  bool active() const { return color_by_ != ColorBy::none; }
  bool colors(CableLook look) const;

  // Takes note of what is needed for the values of a snapshot; call before value(). Without a fixed range: makes the
  // range hold the snapshot's values, up to a round number.
  void update(const Snapshot& snapshot);

  // The value at `fraction` of the way along an element: tension N, Green strain, speed m/s, force of its contacts N.
  double value(const Snapshot& snapshot, std::size_t element, double fraction) const;
  Color color(double value) const;
  Color color_at_fraction(double fraction) const;

  ValueRange range() const { return range_; }

  std::string label() const { return color_label(color_by_); }
  double display_unit() const;  // one unit of the label in SI

 private:
  const Structure& structure_;
  ColorBy color_by_;
  ColorMap map_;
  ValueRange map_part_;  // of the colour map, so that no colour vanishes on the background
  bool fixed_range_;
  ValueRange range_;
  std::vector<double> contact_;  // N, by element; of the snapshot noted last, empty unless coloured by contact
};

// A quantity's value in SI units that one in a hundred of the coloured elements of a snapshot exceeds: one cord that is
// plucked must not darken all others. Of contact forces: of the elements in contact.
double high_value(const Structure& structure, const Snapshot& snapshot, ColorBy color_by);
// The next 1, 2, 2.5 or 5 times a power of ten; 1 for 0.
double round_up(double value);

}  // namespace netpocket
