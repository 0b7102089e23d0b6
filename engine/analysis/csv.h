#pragma once
// Channels as a table that every program reads.

#include <string>

namespace netpocket {

class Recording;

// Writes one row per frame with all channels of the recording in its order, comma separated, under a line of their
// names. Numbers are the shortest that read back to the same double, times
// without the noise of summation. The file appears under `path` only when it is complete and replaces an older one.
// Throws FileError.
void write_channels_csv(const Recording& recording, const std::string& path);

}  // namespace netpocket
