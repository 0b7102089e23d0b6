#pragma once
// Checkpoints in an HDF5 file: group /checkpoints. One table holds the numbers of all states in sequence, another the
// texts of all strategies. Each checkpoint refers to its rows in both.

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
  // A checkpoint exists once its row of times is stored. store_times() is to be called when all else is safe on the
  // disk.
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

  const std::vector<double>& times() const { return times_; }  // s, not decreasing
  // Whether the strategy was changed at this checkpoint.
  bool changes_strategy(std::size_t index) const { return text_ranges_[2 * index + 1] > 0; }
  Checkpoint read(std::size_t index) const;

 private:
  InputTable values_, texts_;
  std::vector<double> times_;
  std::vector<std::int64_t> value_ranges_, text_ranges_;  // pairs: first row, number of rows
};

}  // namespace netpocket
