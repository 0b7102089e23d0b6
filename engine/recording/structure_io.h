#pragma once
// A run's Structure in an HDF5 file: group /structure.

#include "engine/recording/chunk_codec.h"
#include "engine/recording/hdf5_input.h"
#include "engine/state/structure.h"

namespace netpocket {

void write_structure(hid_t file, const Structure& structure, ChunkCodec& codec);

// Reads a structure of a `version` of the format. Checks that every index is valid. Throws Hdf5Error with the reason.
Structure read_structure(const InputFile& file, std::int32_t version);

// What is wrong with a structure (indices, counts, sizes, roles, looks), in a few words; empty when it is valid.
std::string find_fault(const Structure& structure);

}  // namespace netpocket
