#pragma once
// Bias of drafts against the fine mesh. Written by `./dev draft-bias`; not to be edited.

namespace netpocket {

// Mean of draft minus fine over the same captures, and half the width of its 95 % interval.
struct MeasuredBias {
  double mean, half_width;
};

struct DraftBias {
  int captures;
  MeasuredBias probability;    // of capture
  MeasuredBias first_contact;  // s
  MeasuredBias impulse;        // size of the impulse on the target, as a part of its mean
};

inline constexpr DraftBias kDraftBias = {
    .captures = 512,
    .probability = {-0.0039062, 0.0066143},
    .first_contact = {-0.0234043, 0.0172759},
    .impulse = {-0.0213571, 0.0267255},
};

}  // namespace netpocket
