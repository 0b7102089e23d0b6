#include "render/output/mp4_boxes.h"

#include <cstdint>
#include <fstream>

namespace netpocket {
namespace {

struct Mp4Box {
  std::uint64_t size = 0;  // bytes, its head included
  std::string type;
};

std::uint64_t big_endian(const char* bytes, int count) {
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

// The head of a box; of size 0 where there is none.
Mp4Box read_box(std::ifstream& file, std::uint64_t left) {
  constexpr std::uint64_t kHead = 8, kLongHead = 16;
  char head[kLongHead] = {};
  if (left < kHead || !file.read(head, kHead)) return {};
  Mp4Box box{big_endian(head, 4), std::string(head + 4, 4)};
  if (box.size == 0) box.size = left;  // to the end of the file
  if (box.size == 1 && left >= kLongHead && file.read(head + kHead, kHead)) box.size = big_endian(head + kHead, 8);
  return box.size >= kHead ? box : Mp4Box{};
}

}  // namespace

bool is_whole_mp4(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return false;
  const auto end = static_cast<std::uint64_t>(file.tellg());
  bool media = false, index = false;
  for (std::uint64_t at = 0; at < end;) {
    file.seekg(static_cast<std::streamoff>(at));
    const Mp4Box box = read_box(file, end - at);
    if (box.size == 0 || box.size > end - at) return false;
    media = media || box.type == "mdat";
    index = index || box.type == "moov";
    at += box.size;
  }
  return media && index;
}

}  // namespace netpocket
