#pragma once
// The records of a study's points on disk: folder/records/NAME.jsonl, a JSON value a line. Each file has one writer,
// and a line is added when a point is finished, so that a program that is killed loses only the points that it was
// running. Errors: FileError with one sentence.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

// Where a record is, and what its line begins with.
struct RecordPlace {
  std::size_t point = 0;  // 1, 2, ...
  std::string outcome;    // "done", "diverged", "limited" or "refused"
  std::string identity;
  std::string file;
  std::uint64_t offset = 0;  // bytes
  std::size_t length = 0;    // without the end of the line
};

// What a line begins with, without its file and offset; nothing if it is of another form.
std::optional<RecordPlace> parse_record_head(std::string_view line);

// "records/3_of_8.jsonl" in the folder.
std::string records_path(const std::string& folder, int part, int parts);

// All complete lines of all files of the folder, file by file in the order of their names. Lines of another form are
// passed over.
void scan_records(const std::string& folder, const std::function<void(const RecordPlace&)>& use);

// Reads records in any order. Thread contract: one thread at a time per object.
class RecordReader {
 public:
  RecordReader() = default;
  ~RecordReader();
  RecordReader(const RecordReader&) = delete;
  RecordReader& operator=(const RecordReader&) = delete;

  StudyRecord read(const RecordPlace& place);

 private:
  std::string file_;
  int descriptor_ = -1;
};

// Adds records to a file. Thread contract: one thread at a time per object.
class RecordWriter {
 public:
  // Makes the file and its folder if they do not exist. Cuts off a line that a killed program left unfinished. Refuses
  // a file that another program is writing, where the file system knows locks.
  explicit RecordWriter(const std::string& path);
  ~RecordWriter();
  RecordWriter(const RecordWriter&) = delete;
  RecordWriter& operator=(const RecordWriter&) = delete;

  // When it returns, the record survives the death of the program. When it fails, the file is as before.
  void add(const StudyRecord& record);

 private:
  std::string path_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // bytes, of complete lines
};

// Whether a program is writing the file, where the file system knows locks.
bool is_being_written(const std::string& path);

}  // namespace netpocket
