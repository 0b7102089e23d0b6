#pragma once
// What is fuzzed. Each takes any bytes and does what the program does with such a file; a refusal is a success,
// anything else that goes wrong ends the process.

#include <cstdint>
#include <span>

namespace netpocket {

// A scenario: read, checked, written and read back.
void fuzz_scenario(std::span<const std::uint8_t> bytes);

// A recording: bytes that begin as an HDF5 file are one; others are edits of a sound recording (recording_edits.h),
// which get past HDF5's checksums. Opened, read to the end and verified.
void fuzz_recording(std::span<const std::uint8_t> bytes);

}  // namespace netpocket
