#pragma once
// A run's Structure in an HDF5 file: group /structure.

#include "engine/recording/chunk_codec.h"
#include "engine/recording/hdf5_input.h"
#include "engine/state/structure.h"

namespace netpocket {

void write_structure(hid_t file, const Structure& structure, ChunkCodec& codec);

// Checks that every index lies inside what it points into. Throws Hdf5Error with the reason.
// `version` of the format.
Structure read_structure(const InputFile& file, std::int32_t version);

// What is wrong with a structure's indices, in a few words; empty when they are all valid.
std::string find_fault(const Structure& structure);

}  // namespace netpocket
