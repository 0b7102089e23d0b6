#pragma once
// The strategy: the parameters that can be changed during a capture.

#include <string_view>

#include "engine/scenario/parameters.h"

namespace netpocket {

// Whether a change of this parameter ("closing.duration") of a kind of capture system can act on a run in progress. All
// others need a new model.
bool acts_at_once(std::string_view key, std::string_view system = kPocketSystem);

// The same for the pocket, without output.end_time, which acts at once in every kind.
bool acts_at_once_in_pocket(std::string_view key);

}  // namespace netpocket
