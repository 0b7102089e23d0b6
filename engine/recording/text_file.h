#pragma once
// Text files that are whole or not there.

#include <string>

namespace netpocket {

// Writes `text` under another name first, then puts it in its place: a file that stood there stays until the new one is
// whole. Throws RecordingError with one sentence that names the file. Any thread may call it, one for a file.
void write_text_file(const std::string& path, const std::string& text);

}  // namespace netpocket
