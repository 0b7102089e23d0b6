#pragma once
// The outermost structure of MP4 files (ISO/IEC 14496-12): a row of boxes, each with its size and type.

#include <string>

namespace netpocket {

// Whether the boxes fill the file to its end and hold media and an index of them. What was cut off does not.
bool is_whole_mp4(const std::string& path);

}  // namespace netpocket
