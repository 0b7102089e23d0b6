#pragma once
// What was picked, over time: which quantities, their values in a frame, and the plots made of them.

#include <QString>
#include <vector>

#include "gui/workbench/viewport/picker.h"
#include "render/figures/figure.h"

namespace netpocket {

struct PickedQuantity {
  QString title;               // of its panel, plain text
  QString axis;                // quantity and unit, rich text of the figures
  std::vector<QString> names;  // of its curves; one empty name: a single curve
};

// In the order of values_of().
std::vector<PickedQuantity> quantities_of(const Pick& pick);

// One number for each curve, NaN where the frame does not have the thing.
std::vector<double> values_of(const Pick& pick, const Structure& structure, const Snapshot& frame);

// `rows`: the values of each frame.
std::vector<Panel> picked_panels(const std::vector<PickedQuantity>& quantities, const std::vector<double>& times,
                                 const std::vector<std::vector<double>>& rows);

}  // namespace netpocket
