#pragma once
// Verdict on a finding or a capture. Only yes and no are judgements; the others say why there is none.

namespace netpocket {

enum class Verdict {
  yes,
  no,
  undecided,  // the runs are complete but not sufficient: one draw of a chaotic quantity, overlapping intervals
  unknown,    // the recording lacks what is needed: it ends too early, or it has no contact points
  diverged,   // the run diverged, so none of its numbers is a result
};

// "yes", "no", "undecided", "not known", "diverged".
const char* to_string(Verdict verdict);

}  // namespace netpocket
