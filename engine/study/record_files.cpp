#include "engine/study/record_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <thread>

#include "engine/base/folder.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* what, const std::string& path) {
  throw FileError(fmt::format("cannot {} \"{}\": {}", what, path, std::strerror(errno)));
}

// Takes `text` off the front.
bool skip(std::string_view& line, std::string_view text) {
  if (!line.starts_with(text)) return false;
  line.remove_prefix(text.size());
  return true;
}

// Takes the text up to the next quote, and the quote, off the front.
std::string take_text(std::string_view& line) {
  const auto end = std::min(line.find('"'), line.size());
  std::string text(line.substr(0, end));
  line.remove_prefix(std::min(end + 1, line.size()));
  return text;
}

void scan_file(const std::string& path, const std::function<void(const RecordPlace&)>& use) {
  constexpr std::size_t kChunk = 1 << 22;
  const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) fail("read", path);
  std::string text;
  std::uint64_t offset = 0;  // of the text's begin
  for (bool is_end = false; !is_end;) {
    const std::size_t before = text.size();
    text.resize(before + kChunk);
    text.resize(before + std::fread(text.data() + before, 1, kChunk, file.get()));
    is_end = text.size() < before + kChunk;
    std::size_t begin = 0;
    for (auto end = text.find('\n', before); end != text.npos; end = text.find('\n', begin)) {
      if (auto place = parse_record_head(std::string_view(text).substr(begin, end - begin))) {
        place->file = path;
        place->offset = offset + begin;
        use(*place);
      }
      begin = end + 1;
    }
    offset += begin;
    text.erase(0, begin);
  }
}

// Locks a file for writing; false if another program holds it. Tries for a while, because a program that only looks
// whether a file is being written (is_being_written) holds it for a moment.
bool lock_for_writing(int descriptor) {
  constexpr int kTries = 10;
  for (int i = 0; i < kTries; ++i) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

// Size of the complete lines of a file.
std::int64_t complete_size(int descriptor, std::int64_t size) {
  char last = 0;
  for (; size > 0; --size) {
    if (pread(descriptor, &last, 1, size - 1) != 1 || last == '\n') break;
  }
  return size;
}

}  // namespace

std::optional<RecordPlace> parse_record_head(std::string_view line) {
  RecordPlace place;
  place.length = line.size();
  if (!line.ends_with('}') || !skip(line, "{\"point\":")) return std::nullopt;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), place.point);
  if (error != std::errc() || place.point == 0) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  if (!skip(line, ",\"outcome\":\"")) return std::nullopt;
  place.outcome = take_text(line);
  if (!skip(line, ",\"identity\":\"")) return std::nullopt;
  place.identity = take_text(line);
  return place;
}

std::string records_path(const std::string& folder, int part, int parts) {
  return fmt::format("{}/records/{}_of_{}.jsonl", folder, part, parts);
}

void scan_records(const std::string& folder, const std::function<void(const RecordPlace&)>& use) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder + "/records", error)) {
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  for (const std::string& file : files) scan_file(file, use);
}

RecordReader::~RecordReader() {
  if (descriptor_ >= 0) close(descriptor_);
}

StudyRecord RecordReader::read(const RecordPlace& place) {
  if (file_ != place.file) {
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = open(place.file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("read", place.file);
    file_ = place.file;
  }
  std::string line(place.length, '\0');
  const ssize_t size = pread(descriptor_, line.data(), line.size(), static_cast<off_t>(place.offset));
  StudyRecord record = StudyRecord::parse(line, nullptr, false);
  if (size != static_cast<ssize_t>(line.size()) || !record.is_object()) {
    throw FileError(fmt::format("\"{}\" holds a damaged record of point {}", place.file, place.point));
  }
  return record;
}

RecordWriter::RecordWriter(const std::string& path) : path_(path) {
  make_folder(fs::path(path).parent_path().string());
  descriptor_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor_ < 0) fail("write", path);
  if (!lock_for_writing(descriptor_)) {
    close(descriptor_);
    throw FileError(fmt::format("another program is writing \"{}\"", path));
  }
  struct stat status {};
  const bool is_known = fstat(descriptor_, &status) == 0;
  size_ = is_known ? complete_size(descriptor_, status.st_size) : 0;
  if (!is_known || ftruncate(descriptor_, size_) != 0) {
    close(descriptor_);
    fail("write", path);
  }
}

RecordWriter::~RecordWriter() { close(descriptor_); }

void RecordWriter::add(const StudyRecord& record) {
  const std::string line = record.dump() + "\n";
  const ssize_t written = pwrite(descriptor_, line.data(), line.size(), size_);
  if (written == static_cast<ssize_t>(line.size())) {
    size_ += written;
    return;
  }
  const int reason = written < 0 ? errno : ENOSPC;
  // What cannot be cut off now is cut off when the file is opened again.
  [[maybe_unused]] const int ignored = ftruncate(descriptor_, size_);
  errno = reason;
  fail("write", path_);
}

bool is_being_written(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_locked = flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(descriptor);
  return is_locked;
}

}  // namespace netpocket
