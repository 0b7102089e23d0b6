#pragma once
// What is said of a finding or a capture. Only yes and no are judgements; the others say why there is none.

namespace netpocket {

enum class Verdict {
  yes,
  no,
  undecided,  // the runs are complete and do not decide it: one draw of a chaotic quantity, overlapping intervals
  unknown,    // the recording does not hold what it takes: it ends too early, or it has no contact points
  diverged,   // the run diverged: none of its numbers is a result
};

// "yes", "no", "undecided", "not known", "diverged".
const char* to_string(Verdict verdict);

}  // namespace netpocket
