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

// Throws CommandError(usage) when pictures at `rate` (1/s) of all that is recorded would be more than anybody can want.
void require_fewer_pictures(const std::vector<const Recording*>& recordings, double rate);

}  // namespace netpocket
