#pragma once
// The end of a run in an HDF5 file: group /outcome. Its tables have no row until the run has ended, then one.

#include <optional>
#include <vector>

#include "engine/recording/hdf5_input.h"
#include "engine/recording/hdf5_output.h"
#include "engine/state/run_status.h"

namespace netpocket {

class OutcomeTables {
 public:
  OutcomeTables(hid_t file, ChunkCodec& codec);
  void write(hid_t file, const RunStatus& status, const RunStatistics& statistics);

 private:
  Handle group_;
  std::vector<OutputTable> texts_;
  std::vector<OutputTable> numbers_;
};

struct Outcome {
  RunStatus status;
  RunStatistics statistics;
};

// Nothing when the run was cut off. Throws Hdf5Error.
std::optional<Outcome> read_outcome(const InputFile& file);

}  // namespace netpocket
