#pragma once
// Folders that outputs go to.

#include <string>

namespace netpocket {

// Makes a folder and those above it where they are missing. Throws FileError, also when nothing can be written there.
void make_folder(const std::string& path);

// Waits until the names in a folder are on the disk. Where folders cannot be synchronised, the names follow when the
// system sees fit. False, with errno, when the disk failed.
bool sync_folder(const std::string& path);

}  // namespace netpocket
