#include "engine/study/record_follower.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace netpocket {
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 20;  // of a file, at a time

// The complete lines from `offset` on, as far as they fit; a line that does not fit is read alone.
std::string complete_lines(const std::string& path, std::uint64_t offset) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  std::string text;
  for (std::size_t size = kMostBytes; text.find('\n') == text.npos; size *= 2) {
    const std::size_t before = text.size();
    text.resize(size);
    file.read(text.data() + before, static_cast<std::streamsize>(size - before));
    text.resize(before + static_cast<std::size_t>(file.gcount()));
    if (text.size() < size) break;
  }
  const auto end = text.rfind('\n');
  text.resize(end == text.npos ? 0 : end + 1);
  return text;
}

}  // namespace

std::vector<FollowedRecord> RecordFollower::read_new() {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ + "/records", error)) {
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  std::vector<FollowedRecord> found;
  for (const std::string& file : files) {
    read_file(file, found);
    if (!found.empty()) break;
  }
  return found;
}

void RecordFollower::read_file(const std::string& path, std::vector<FollowedRecord>& found) {
  std::uint64_t& offset = read_[path];
  const std::string text = complete_lines(path, offset);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    if (auto place = parse_record_head({text.data() + begin, end - begin})) {
      place->file = path;
      place->offset = offset + begin;
      StudyRecord record = StudyRecord::parse(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                              text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
      if (record.is_object()) found.push_back({std::move(*place), std::move(record)});
    }
    begin = end + 1;
  }
  offset += text.size();
}

}  // namespace netpocket
