#pragma once
// The netted pocket as a capture system: its model (pocket.h), the controllers that close and tow it, its channels and
// its phases.

#include "engine/systems/capture_system.h"

namespace netpocket {

CaptureSystemKind pocket_kind();

}  // namespace netpocket
