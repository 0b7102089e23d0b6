#pragma once
// What ends the searches of segment_contact.h, for one piece and for eight at once alike.

#include <limits>

namespace netpocket::search_limits {

// Uncertainty (m) of the nearest distance at which the search ends: a thousandth of usual depths.
inline constexpr double kTolerance = 1e-8;
inline constexpr int kMostTrials = 40;

// Of the search for the deepest place.
inline constexpr int kMostDeepTrials = 30;
inline constexpr double kFlat = 0.01;    // slope that is left, by that at the nearest place
inline constexpr double kClose = 1e-7;   // m: places nearer than this to each other are one
inline constexpr double kInside = 1e-3;  // of the present bounds: the next place is at least so far from both

// As in shape.cpp: a squared length below this has lost its digits by underflow and gives no direction.
inline constexpr double kSmallestSquare = std::numeric_limits<double>::min();

}  // namespace netpocket::search_limits
