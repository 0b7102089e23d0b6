#pragma once
// A made-up run of any size for the tests of the recording layer: every number follows from its indices.

#include <filesystem>
#include <string>

#include "engine/recording/recorder.h"

namespace netpocket {

Structure synthetic_structure(int elements);
Snapshot synthetic_frame(const Structure& structure, int index);
// At `index` seconds; `size` numbers.
Checkpoint synthetic_checkpoint(int index, int size = 10000);
RunOrigin synthetic_origin();

// Writes `frames` frames, 50 a second, and checkpoints of a small run and finishes it.
void write_synthetic_run(const std::string& path, int frames, int elements = 20, int checkpoint_size = 10000);

// A folder of its own for each test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string read_bytes(const std::string& path);
void write_bytes(const std::string& path, const std::string& bytes);

}  // namespace netpocket
