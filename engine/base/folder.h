#pragma once
// Folders that outputs go to.

#include <string>

namespace netpocket {

// Makes a folder and its missing parents. Throws FileError if that fails or if the folder is not writable.
void make_folder(const std::string& path);

// Waits until the names in a folder are on the disk. If the folder cannot be synchronised, it returns true and the
// system writes the names later. Returns false, with errno, if the disk failed.
bool sync_folder(const std::string& path);

}  // namespace netpocket
