#include "tests/engine/recording/disk_log.h"

#include <dlfcn.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <map>
#include <string_view>
#include <utility>

namespace netpocket::test {
namespace {

// What storage writes as a whole.
constexpr std::size_t kPage = 4096;

DiskLog* active = nullptr;
std::mutex disk;
std::function<void(int)> lock_action;

template <typename Function>
Function system_function(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// Part of a write that falls into one page.
struct Piece {
  std::size_t offset;
  const char* bytes;
  std::size_t size;
};

void apply(std::string& file, std::size_t offset, const char* bytes, std::size_t size) {
  if (file.size() < offset + size) file.resize(offset + size, '\0');
  std::copy_n(bytes, size, file.begin() + static_cast<std::ptrdiff_t>(offset));
}

}  // namespace

DiskLog::DiskLog(std::string path) : path_(std::move(path)) { active = this; }

DiskLog::~DiskLog() { active = nullptr; }

bool DiskLog::is_ours(int file) const {
  char name[PATH_MAX];
  const ssize_t length = readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), name, sizeof name);
  // Its working name begins with its later one.
  return length > 0 && std::string_view(name, static_cast<std::size_t>(length)).starts_with(path_);
}

void DiskLog::note_write(int file, const void* data, std::size_t size, std::int64_t offset) {
  if (!is_ours(file)) return;
  events_.push_back({Kind::write, static_cast<std::size_t>(offset), {static_cast<const char*>(data), size}});
}

void DiskLog::note_size(int file, std::int64_t size) {
  if (is_ours(file)) events_.push_back({Kind::resize, static_cast<std::size_t>(size), {}});
}

void DiskLog::note_sync(int file) {
  if (is_ours(file)) events_.push_back({Kind::sync, 0, {}});
}

std::string DiskLog::after_power_cut(std::size_t count, std::mt19937& random) const {
  const auto end = events_.begin() + static_cast<std::ptrdiff_t>(std::min(count, events_.size()));
  const auto is_sync = [](const Event& event) { return event.kind == Kind::sync; };
  const auto synced = std::find_if(std::reverse_iterator(end), events_.rend(), is_sync).base();
  std::string file;
  for (auto event = events_.begin(); event != synced; ++event) {
    if (event->kind == Kind::write) apply(file, event->offset, event->bytes.data(), event->bytes.size());
    if (event->kind == Kind::resize) file.resize(event->offset, '\0');
  }
  std::map<std::size_t, std::vector<Piece>> pages;
  for (auto event = synced; event != end; ++event) {
    for (std::size_t at = 0; at < event->bytes.size();) {
      const std::size_t offset = event->offset + at, page = offset / kPage;
      const std::size_t size = std::min(event->bytes.size() - at, (page + 1) * kPage - offset);
      pages[page].push_back({offset, event->bytes.data() + at, size});
      at += size;
    }
  }
  for (const auto& [page, pieces] : pages) {
    const std::size_t stored = random() % (pieces.size() + 1);
    for (std::size_t i = 0; i < stored; ++i) apply(file, pieces[i].offset, pieces[i].bytes, pieces[i].size);
  }
  return file;
}

HeldDisk::HeldDisk() : lock_(disk) {}

void before_next_lock(std::function<void(int)> action) { lock_action = std::move(action); }

void act_before_lock(int file) {
  if (const auto action = std::exchange(lock_action, nullptr)) action(file);
}

void wait_for_disk() { const std::lock_guard wait(disk); }

}  // namespace netpocket::test

// These take the place of the C library's, for HDF5 too.
extern "C" {

ssize_t pwrite(int file, const void* data, size_t size, off_t offset) {
  static const auto write = netpocket::test::system_function<decltype(&pwrite)>("pwrite");
  const ssize_t written = write(file, data, size, offset);
  if (netpocket::test::active && written > 0) {
    netpocket::test::active->note_write(file, data, static_cast<std::size_t>(written), offset);
  }
  return written;
}

int ftruncate(int file, off_t size) noexcept {
  static const auto truncate = netpocket::test::system_function<decltype(&ftruncate)>("ftruncate");
  const int result = truncate(file, size);
  if (netpocket::test::active && result == 0) netpocket::test::active->note_size(file, size);
  return result;
}

int fdatasync(int file) {
  static const auto sync = netpocket::test::system_function<decltype(&fdatasync)>("fdatasync");
  netpocket::test::wait_for_disk();
  const int result = sync(file);
  if (netpocket::test::active && result == 0) netpocket::test::active->note_sync(file);
  return result;
}

int flock(int file, int operation) noexcept {
  static const auto lock = netpocket::test::system_function<decltype(&flock)>("flock");
  netpocket::test::act_before_lock(file);
  return lock(file, operation);
}
}
