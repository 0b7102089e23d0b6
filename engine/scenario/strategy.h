#pragma once
// Which parameters make up the strategy: what can be changed while a capture goes on.

#include <string_view>

namespace netpocket {

// Whether a change of this parameter ("closing.duration") acts on a run from now on. Everything else makes another
// model.
bool acts_at_once(std::string_view key);

}  // namespace netpocket
