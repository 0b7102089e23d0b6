#pragma once
// The file of a recording as the operating system sees it: its working name, its lock and its room on the disk.
// Errors: FileError; OutputRefused when `path` is a file that is not a recording.

#include <sys/stat.h>

#include <cstdint>
#include <string>

#include "engine/base/destination.h"

namespace netpocket {

class OutputFile {
 public:
  // Creates and locks `path` + ".part", with links followed. Refuses an existing `path` unless `overwrite`, and always
  // one that another program is writing.
  OutputFile(const std::string& path, bool overwrite);
  ~OutputFile() { close(); }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return name_; }  // as given to the constructor
  const std::string& working_path() const { return published_ ? path_ : part_path_; }

  // Ensures that the disk has room for the file to grow beyond `used` bytes. Room is reserved in steps ahead of need,
  // so that a full disk is noticed while HDF5 can still write what it holds and close the file.
  void ensure_room(std::uint64_t used);

  // Waits until everything written is on the disk, so that it survives a loss of power.
  void sync();

  // Whether the path still leads to this file: it was not deleted, moved or replaced. Data written to a file without a
  // name may be lost.
  bool has_name() const { return has_name(working_path()); }
  void require_name() const;
  [[noreturn]] void fail_nameless() const;
  // Throws when somebody else has truncated the file since the last call of this function or of sync().
  void require_whole();

  // Moves the file to its final name and replaces an existing file. Further calls do nothing.
  void publish();
  bool is_published() const { return published_; }

  // Releases unused room and the lock. Removes the file when it was never published.
  void close();

 private:
  Destination checked_target() const;
  void open_and_lock();
  bool has_name(const std::string& path) const;
  bool has_its_room(const struct stat& status) const;
  void reserve(std::uint64_t size);

  std::string name_;
  std::string path_;
  std::string part_path_;
  bool overwrite_;
  bool published_ = false;
  int descriptor_ = -1;
  std::uint64_t reserved_ = 0;
  off_t seen_size_ = 0;
};

}  // namespace netpocket
