#pragma once
// Checkpoints in an HDF5 file: group /checkpoints. One table holds the numbers of all states, one after the other, and
// one the texts of all strategies; each checkpoint names its rows of both.

#include <string>
#include <vector>

#include "engine/recording/hdf5_input.h"
#include "engine/recording/hdf5_output.h"
#include "engine/state/checkpoint.h"

namespace netpocket {

class CheckpointTables {
 public:
  CheckpointTables(hid_t file, ChunkCodec& codec);

  void append(const Checkpoint& checkpoint);
  // A checkpoint exists when its row of times does: that one is stored when all else is safe.
  void store_states();
  void store_times();

 private:
  void append_range(OutputTable& ranges, const OutputTable& rows, std::size_t count);

  Handle group_;
  OutputTable values_, value_range_, texts_, text_range_, time_;
};

class CheckpointReader {
 public:
  // Throws Hdf5Error, as read() does.
  explicit CheckpointReader(const InputFile& file);

  const std::vector<double>& times() const { return times_; }  // s, never falling
  // Whether a strategy took over there.
  bool changes_strategy(std::size_t index) const { return text_ranges_[2 * index + 1] > 0; }
  Checkpoint read(std::size_t index) const;

 private:
  InputTable values_, texts_;
  std::vector<double> times_;
  std::vector<std::int64_t> value_ranges_, text_ranges_;  // first row, number of rows
};

}  // namespace netpocket
