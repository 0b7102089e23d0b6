#pragma once
// Follows the records of a study's folder while programs write them. Thread contract: one thread at a time per object.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/study/record_files.h"

namespace netpocket {

struct FollowedRecord {
  RecordPlace place;
  StudyRecord record;
};

class RecordFollower {
 public:
  // The folder need not hold any record yet.
  explicit RecordFollower(std::string folder) : folder_(std::move(folder)) {}

  // Records whose lines were completed since they were last asked for, some megabytes of them at most: empty when there
  // is nothing more for now. Lines of another form are passed over. Throws FileError.
  std::vector<FollowedRecord> read_new();

 private:
  void read_file(const std::string& path, std::vector<FollowedRecord>& found);

  std::string folder_;
  std::map<std::string, std::uint64_t> read_;  // by file: bytes that were read
};

}  // namespace netpocket
