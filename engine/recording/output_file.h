#pragma once
// The file a recording goes to, as the operating system sees it: its working name, its lock and its room on the disk.
// Errors: FileError; OutputRefused where a file stands that is no recording.

#include <cstdint>
#include <string>

#include "engine/base/destination.h"

namespace netpocket {

class OutputFile {
 public:
  // Creates and locks `path` + ".part", links followed. Refuses an existing `path` unless `overwrite`, and one that
  // another program is writing always.
  OutputFile(const std::string& path, bool overwrite);
  ~OutputFile() { close(); }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return name_; }  // as it was named
  const std::string& working_path() const { return published_ ? path_ : part_path_; }

  // Makes sure that the disk has room for the file to grow beyond `used` bytes. Room is reserved in steps ahead of
  // need, so a full disk is noticed while HDF5 can still write what it holds and close the file.
  void ensure_room(std::uint64_t used);

  // Waits until everything written is on the disk, so that it survives the loss of power.
  void sync();

  // Whether it is still where it was put: nobody has deleted, moved or replaced it. What is written to a file that lost
  // its name may reach nobody.
  bool has_name() const { return has_name(working_path()); }
  void require_name() const;
  [[noreturn]] void fail_nameless() const;
  // Throws when somebody else has cut the file short since it was last asked, or synchronised.
  void require_whole();

  // Moves the file to its final name, replacing an older one. Does nothing the second time.
  void publish();
  bool is_published() const { return published_; }

  // Gives back unused room and the lock; removes the file when it was never published.
  void close();

 private:
  Destination checked_target() const;
  void open_and_lock();
  bool has_name(const std::string& path) const;
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
