#pragma once
// The origin of a run in an HDF5 file: attributes and datasets of the root. Errors: Hdf5Error.

#include "engine/recording/chunk_codec.h"
#include "engine/recording/hdf5_input.h"
#include "engine/recording/hdf5_output.h"
#include "engine/recording/recorder.h"

namespace netpocket {

void write_origin(hid_t file, const RunOrigin& origin, ChunkCodec& codec);
RunOrigin read_origin(const InputFile& file);

}  // namespace netpocket
