#pragma once
// The thrown net as a capture system: its model (thrown_net.h), the controllers that close and tow it, its channels and
// its phases.

#include "engine/systems/capture_system.h"

namespace netpocket {

CaptureSystemKind thrown_net_kind();

}  // namespace netpocket
