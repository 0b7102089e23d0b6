#include "engine/bodies/stl_file.h"

#include <fmt/format.h>

#include <bit>
#include <cctype>
#include <cstring>
#include <string>

#include "engine/bodies/mesh_text.h"

namespace netpocket {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kRecordBytes = 50;  // normal, three corners, two unused bytes
constexpr std::size_t kFirstRecord = kHeaderBytes + 4;

void add_triangle(MeshData& mesh, const std::array<Eigen::Vector3d, 3>& corners) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

std::size_t stated_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes, sizeof(count));
  return count;
}

// Some programs write "solid" into binary headers too, so the length of the file decides.
bool is_binary(std::string_view bytes) {
  return bytes.size() >= kFirstRecord && bytes.size() == kFirstRecord + kRecordBytes * stated_triangles(bytes);
}

MeshData parse_binary(std::string_view bytes, double scale) {
  const std::size_t count = stated_triangles(bytes);
  require_room_for_triangles(count);
  MeshData mesh;
  mesh.vertices.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + kFirstRecord + kRecordBytes * i, sizeof(numbers));
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = scale * Eigen::Vector3f(numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]).cast<double>();
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

// Parses words independently of lines, because a file may consist of a single line.
class AsciiStl {
 public:
  AsciiStl(std::string_view text, double scale) : words_(text, '\0'), scale_(scale) {}

  MeshData parse() {
    while (words_.next_line()) {
      for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) take(lower_case(word));
    }
    if (count_ != 0 || !ended_) throw MeshFileError("is cut off: \"endsolid\" is missing");
    return std::move(mesh_);
  }

 private:
  void take(const std::string& word) {
    if (word == "vertex") {
      add_corner();
    } else if (word == "endfacet") {
      end_facet();
    } else if (word == "solid" || word == "endsolid") {
      ended_ = ended_ || word == "endsolid";
      skip_name();
    } else if (word == "end") {  // "end loop" may be two words
      const std::string what = lower_case(words_.next());
      if (what.empty()) words_.fail("this is not STL");
      take("end" + what);
    } else if (word == "facet" || word == "color" || word == "colour") {
      ended_ = ended_ && word != "facet";
      skip_numbers();
    } else if (word != "outer" && word != "loop" && word != "endloop") {
      words_.fail("this is not STL");
    }
  }

  void add_corner() {
    if (count_ == 3) words_.fail("a facet has more than three vertices");
    corners_[count_++] = scale_ * words_.vector();
  }

  void end_facet() {
    if (count_ != 3) words_.fail("a facet has fewer than three vertices");
    require_room_for_triangles(mesh_.triangles.size() + 1);
    add_triangle(mesh_, corners_);
    count_ = 0;
  }

  // Skips a name. It ends with the line, or where a facet or another solid begins.
  void skip_name() {
    for (std::string word = lower_case(words_.peek()); !word.empty(); word = lower_case(words_.peek())) {
      if (word == "facet" || word == "endsolid" || (ended_ && word == "solid")) return;
      words_.next();
    }
  }

  // Skips a normal, which the corners give more accurately, or a colour.
  void skip_numbers() {
    const auto is_number = [](std::string_view word) {
      const std::string lower = lower_case(word);
      return std::string_view("0123456789+-.").find(lower[0]) != std::string_view::npos || lower == "normal" ||
             lower.starts_with("nan") || lower.starts_with("inf");
    };
    while (!words_.peek().empty() && is_number(words_.peek())) words_.next();
  }

  MeshWords words_;
  double scale_;
  MeshData mesh_;
  std::array<Eigen::Vector3d, 3> corners_;
  std::size_t count_ = 0;
  bool ended_ = false;  // since the last facet
};

// Throws the reason why bytes that are neither binary nor ASCII STL cannot be read.
[[noreturn]] void refuse(std::string_view bytes) {
  if (bytes.empty()) throw MeshFileError("is empty");
  if (bytes.size() < kFirstRecord) {
    throw MeshFileError("is not STL: it does not begin with \"solid\" and is too short for a binary file");
  }
  const std::size_t count = stated_triangles(bytes), expected = kFirstRecord + kRecordBytes * count;
  throw MeshFileError(fmt::format("is not STL, or is {}: {} triangles, as it states, take {} bytes, and it has {}",
                                  bytes.size() < expected ? "cut off" : "longer than it says", count, expected,
                                  bytes.size()));
}

}  // namespace

MeshData parse_stl(std::string_view bytes, double scale) {
  if (is_binary(bytes)) return parse_binary(bytes, scale);
  const bool utf16 = bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
  std::string_view text = bytes;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const auto first = text.find_first_not_of(" \t\r\n");
  const bool is_text = first != text.npos && lower_case(text.substr(first, 5)) == "solid";
  if (utf16 || (is_text && bytes.find('\0') == bytes.npos)) return AsciiStl(plain_text(bytes), scale).parse();
  refuse(bytes);
}

}  // namespace netpocket
