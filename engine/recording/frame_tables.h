#pragma once
// Writes the frames of a run: groups /frames and /contacts.

#include <optional>
#include <vector>

#include "engine/recording/hdf5_output.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

class FrameTables {
 public:
  FrameTables(hid_t file, const Structure& structure, ChunkCodec& codec);

  // Large tables are given to HDF5 at once, small ones with store_frames() and store_channels().
  void append(const Snapshot& snapshot);

  // A frame exists once its row of channels is stored. store_channels() is to be called when all else is safe on the
  // disk.
  void store_frames();
  void store_channels();

 private:
  void create_large_tables(const Structure& structure, ChunkCodec& codec);
  void create_small_tables(const Structure& structure, ChunkCodec& codec);
  void create_contact_tables(ChunkCodec& codec);
  void describe_channels(const ChannelList& channels);
  void append_bodies(const std::vector<BodyState>& bodies);
  void append_contacts(const std::vector<ContactPoint>& contacts);
  template <typename Matrix>
  void append_single(std::optional<OutputTable>& table, const Matrix& values);

  Handle frames_, contacts_;
  // Tables without columns (such as of ropes when there are none) are omitted.
  std::optional<OutputTable> position_, velocity_, gradient_, tension_, strain_;
  std::optional<OutputTable> rope_, body_, step_, contact_range_, channels_;
  std::optional<OutputTable> contact_position_, contact_force_, contact_element_, contact_body_;
  std::vector<float> single_;
};

}  // namespace netpocket
