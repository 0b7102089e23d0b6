#include "engine/state/run_status.h"

namespace netpocket {

const char* to_string(RunReason reason) {
  switch (reason) {
    case RunReason::running:
      return "running";
    case RunReason::finished:
      return "finished";
    case RunReason::stopped:
      return "stopped";
    case RunReason::diverged:
      return "diverged";
    case RunReason::storage_failed:
      return "storage_failed";
    case RunReason::limited:
      return "limited";
  }
  return "unknown";
}

}  // namespace netpocket
