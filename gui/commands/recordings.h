#pragma once
// Opens the recordings that the user names. Throw CommandError(bad_input).

#include <string>
#include <vector>

#include "engine/recording/recording.h"

namespace netpocket {

Recording open_recording(const std::string& path);
std::vector<Recording> open_recordings(const std::vector<std::string>& paths);

// For library functions that take several.
std::vector<const Recording*> pointers(const std::vector<Recording>& recordings);

}  // namespace netpocket
