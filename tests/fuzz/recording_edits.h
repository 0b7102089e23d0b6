#pragma once
// Damages a recording as only a program can: with HDF5's own functions, so that every checksum fits.

#include <cstdint>
#include <span>
#include <string>

namespace netpocket {

// Reads the bytes as a list of edits (remove, replace an attribute or a table, change numbers or sizes, link elsewhere)
// and makes them in the file.
void edit_recording(const std::string& path, std::span<const std::uint8_t> edits);

}  // namespace netpocket
