#pragma once
// What a recording says about how far its run can be trusted: how deep contacts went, and why, and how often safeguards
// acted. Recordings made before the channels existed do not know.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/recording/recording.h"

namespace netpocket {

struct DeepestContact {
  double time = 0;       // s, of the frame that follows it
  double depth = 0;      // m
  double part = 0;       // the depth by the cord's radius, of two cords by the sum of theirs
  double stiffness = 1;  // of the contact, by that of the materials
  std::string cord;      // "panel 3 row 2 (element 12)"
  std::string partner;   // "the target", or the other cord
};

// Nothing where there was no contact, or where it was not recorded.
std::optional<DeepestContact> deepest_penetration(const Recording& recording);  // of a cord into a body
std::optional<DeepestContact> deepest_overlap(const Recording& recording);      // of two cords

// How deep, where, when, and how stiff the contact is: one sentence, or "none".
std::string penetration_text(const Recording& recording);
std::string overlap_text(const Recording& recording);

struct SafeguardCount {
  std::string_view name;   // of the channel
  std::string_view words;  // "steps shortened"
  double value = 0;
};

// At the end of the run; empty where they were not recorded.
std::vector<SafeguardCount> safeguard_counts(const Recording& recording);
// "steps shortened 120, overlaps parted 7", those that have acted; or that none has.
std::string safeguards_text(const Recording& recording);

}  // namespace netpocket
