#pragma once
// The strategy: the parameters that can be changed during a capture.

#include <string_view>

namespace netpocket {

// Whether a change of this parameter ("closing.duration") can act on a run in progress. All others need a new model.
bool acts_at_once(std::string_view key);

}  // namespace netpocket
