#pragma once
// Writes channels as a CSV table.

#include <string>

namespace netpocket {

class Recording;

// Writes a header line of channel names and one row per frame, comma separated, with all channels of the recording in
// its order. Numbers have the fewest digits that read back to the same double. Times are written without the rounding
// errors of summation. The file appears under `path` only when it is complete, and replaces an existing one. Throws
// FileError.
void write_channels_csv(const Recording& recording, const std::string& path);

}  // namespace netpocket
