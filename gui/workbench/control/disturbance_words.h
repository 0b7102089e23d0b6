#pragma once
// What the window calls a disturbance.

#include <QString>

#include "engine/scenario/control_parameters.h"

namespace netpocket {

// "20 N m about y on the spacecraft for 1 s": by its torque if it has one, by the largest component.
QString disturbance_words(const DisturbanceParameters& disturbance);

}  // namespace netpocket
