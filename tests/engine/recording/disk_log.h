#pragma once
// What a program gives a file, in the order in which it does, and what a loss of power may leave of it. The test
// program's own pwrite, ftruncate, fdatasync and flock stand before those of the system (disk_log.cpp).
// Thread contract: one file at a time.

#include <cstdint>
#include <functional>
#include <mutex>
#include <random>
#include <string>
#include <vector>

namespace netpocket::test {

// Notes all writes to a file, which may have further letters behind its name, while it lives.
class DiskLog {
 public:
  explicit DiskLog(std::string path);  // canonical
  ~DiskLog();
  DiskLog(const DiskLog&) = delete;
  DiskLog& operator=(const DiskLog&) = delete;

  std::size_t size() const { return events_.size(); }

  // The file after the power failed with the first `count` events done: what was synchronised is there; of what was
  // written later the system has stored some pages and not others, each in one of the states it had meanwhile.
  std::string after_power_cut(std::size_t count, std::mt19937& random) const;

  void note_write(int file, const void* data, std::size_t size, std::int64_t offset);
  void note_size(int file, std::int64_t size);
  void note_sync(int file);

 private:
  enum class Kind { write, resize, sync };
  struct Event {
    Kind kind;
    std::size_t offset;  // of a write; the new size
    std::string bytes;
  };
  bool is_ours(int file) const;

  std::string path_;
  std::vector<Event> events_;
};

// While it lives, synchronising any file waits, as on a disk that is slow.
class HeldDisk {
 public:
  HeldDisk();

 private:
  std::unique_lock<std::mutex> lock_;
};

// Called once, with the file's descriptor, before the next lock on a file is taken.
void before_next_lock(std::function<void(int)> action);

}  // namespace netpocket::test
