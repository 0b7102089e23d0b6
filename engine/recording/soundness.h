#pragma once
// Shows how far a run can be trusted: how deep its contacts went and why, and how often safeguards acted. Recordings
// made before these channels existed do not contain this.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/recording/run_data.h"

namespace netpocket {

struct DeepestContact {
  double time = 0;       // s, of the frame that follows the contact
  double depth = 0;      // m
  double part = 0;       // depth as a fraction of the cord's radius; for two cords of the sum of their radii
  double stiffness = 1;  // stiffness of the contact as a fraction of that of the materials
  std::string cord;      // "panel 3 row 2 (element 12)"
  std::string partner;   // "the target", or the other cord
};

// Nothing when there was no contact, or when it was not recorded.
std::optional<DeepestContact> deepest_penetration(const RunData& run);  // of a cord into a body
std::optional<DeepestContact> deepest_overlap(const RunData& run);      // of two cords

// Depth, place, time and stiffness of the contact in one sentence, or "none".
std::string penetration_text(const RunData& run);
std::string overlap_text(const RunData& run);

struct SafeguardCount {
  std::string_view name;   // of the channel
  std::string_view words;  // "steps shortened"
  double value = 0;
};

// Counts at the end of the run; empty when they were not recorded.
std::vector<SafeguardCount> safeguard_counts(const RunData& run);
// Safeguards that have acted, such as "steps shortened 120, overlaps relaxed 7", or that none has.
std::string safeguards_text(const RunData& run);

}  // namespace netpocket
