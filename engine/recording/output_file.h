#pragma once
// The file a recording goes to, as the operating system sees it: its working name, its lock and its room on the disk.
// Errors: RecordingError.

#include <cstdint>
#include <string>

namespace netpocket {

class OutputFile {
 public:
  // Creates and locks `path` + ".part". Refuses an existing `path` unless `overwrite`, and one that another program is
  // writing always.
  OutputFile(const std::string& path, bool overwrite);
  ~OutputFile() { close(); }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }
  const std::string& working_path() const { return published_ ? path_ : part_path_; }

  // Makes sure that the disk has room for the file to grow beyond `used` bytes. Room is reserved in steps ahead of
  // need, so a full disk is noticed while HDF5 can still write what it holds and close the file.
  void ensure_room(std::uint64_t used);

  // Waits until everything written is on the disk, so that it survives the loss of power.
  void sync();

  // Moves the file to its final name, replacing an older one. Does nothing the second time.
  void publish();
  bool is_published() const { return published_; }

  // Gives back unused room and the lock; removes the file when it was never published.
  void close();

 private:
  void check_target() const;
  void reserve(std::uint64_t size);
  void sync_folder() const;

  std::string path_;
  std::string part_path_;
  bool overwrite_;
  bool published_ = false;
  int descriptor_ = -1;
  std::uint64_t reserved_ = 0;
};

}  // namespace netpocket
