#include "engine/analysis/verdict.h"

namespace netpocket {

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::yes:
      return "yes";
    case Verdict::no:
      return "no";
    case Verdict::undecided:
      return "undecided";
    case Verdict::unknown:
      return "not known";
    case Verdict::diverged:
      return "diverged";
  }
  return "not known";
}

}  // namespace netpocket
