#include "engine/bodies/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace netpocket {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kRecordBytes = 50;  // normal, three corners, two spare bytes

// Ends the reading of a file; never leaves this file.
class MeshFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require_room(std::size_t triangles) {
  if (triangles > kLargestTriangleCount) {
    throw MeshFileError(fmt::format("has more than the {} triangles that are allowed", kLargestTriangleCount));
  }
}

void add_triangle(MeshData& mesh, const std::array<Eigen::Vector3d, 3>& corners) {
  const auto first = static_cast<std::int32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

// ---- text ----

// Goes through a text word by word, line by line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  // Goes to the next line; false at the end.
  bool next_line() {
    if (rest_.empty()) return false;
    const auto end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_ = end == rest_.npos ? std::string_view() : rest_.substr(end + 1);
    ++number_;
    return true;
  }
  // The next word of the line; empty at its end.
  std::string_view next() {
    constexpr std::string_view kBlank = " \t\r\v\f";
    const auto first = std::min(line_.find_first_not_of(kBlank), line_.size());
    const auto last = std::min(line_.find_first_of(kBlank, first), line_.size());
    const std::string_view word = line_.substr(first, last - first);
    line_ = line_.substr(last);
    return word;
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw MeshFileError(fmt::format("cannot be read: line {}: {}", number_, problem));
  }
  double number() {
    const std::string_view word = next();
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size())
      fail("a coordinate is not a number");
    return value;
  }
  Eigen::Vector3d vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  std::string_view text_, rest_ = text_, line_;
  int number_ = 0;
};

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

// ---- STL ----

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes + 4) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes, sizeof(count));
  // Programs write "solid" into binary headers too; the length does not lie.
  return bytes.size() == kHeaderBytes + 4 + kRecordBytes * std::size_t{count};
}

MeshData parse_binary_stl(std::string_view bytes, double scale) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeaderBytes, sizeof(count));
  require_room(count);
  MeshData mesh;
  mesh.vertices.reserve(3 * std::size_t{count});
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers;
    std::memcpy(numbers.data(), bytes.data() + kHeaderBytes + 4 + kRecordBytes * i, sizeof(numbers));
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = scale * Eigen::Vector3f(numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]).cast<double>();
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

MeshData parse_ascii_stl(std::string_view bytes, double scale) {
  Words words(bytes);
  MeshData mesh;
  std::array<Eigen::Vector3d, 3> corners;
  std::size_t count = 0;
  bool ended = false;
  while (words.next_line()) {
    const std::string word = lower_case(words.next());
    if (word == "vertex") {
      if (count == 3) words.fail("a facet has more than three vertices");
      corners[count++] = scale * words.vector();
    } else if (word == "endfacet") {
      if (count != 3) words.fail("a facet has fewer than three vertices");
      require_room(mesh.triangles.size() + 1);
      add_triangle(mesh, corners);
      count = 0;
    } else if (word == "endsolid") {
      ended = true;
    } else if (!word.empty() && word != "solid" && word != "facet" && word != "outer" && word != "endloop") {
      words.fail("this is not STL");
    }
  }
  if (count != 0 || !ended) throw MeshFileError("is cut off: \"endsolid\" is missing");
  return mesh;
}

MeshData parse_stl(std::string_view bytes, double scale) {
  if (is_binary_stl(bytes)) return parse_binary_stl(bytes, scale);
  const auto first = bytes.find_first_not_of(" \t\r\n");
  if (first != bytes.npos && lower_case(bytes.substr(first, 5)) == "solid") return parse_ascii_stl(bytes, scale);
  throw MeshFileError(bytes.empty() ? "is empty"
                                    : "is not STL, or is cut off: its length does not fit its number of triangles");
}

// ---- OBJ ----

// "7", "7/1", "7//3", "-1": the first number, counted from 1 or backwards from the newest vertex.
std::int32_t parse_corner(std::string_view word, std::size_t vertex_count, const Words& words) {
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) words.fail("a corner of a face is not a number");
  const auto count = static_cast<std::int64_t>(vertex_count);
  const std::int64_t index = number < 0 ? count + number : number - 1;
  if (index < 0 || index >= count) words.fail("a face names a vertex that does not exist");
  return static_cast<std::int32_t>(index);
}

void add_face(MeshData& mesh, Words& words) {
  std::array<std::int32_t, 3> fan{};
  int corners = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next(), ++corners) {
    const std::int32_t corner = parse_corner(word, mesh.vertices.size(), words);
    if (corners < 2) {
      fan[corners] = corner;
      continue;
    }
    fan[2] = corner;
    require_room(mesh.triangles.size() + 1);
    mesh.triangles.push_back(fan);
    fan[1] = corner;
  }
  if (corners < 3) words.fail("a face has fewer than three corners");
}

MeshData parse_obj(std::string_view bytes, double scale) {
  Words words(bytes);
  MeshData mesh;
  while (words.next_line()) {
    const std::string_view word = words.next();
    if (word == "v") {
      require_room(mesh.vertices.size() / 3);
      mesh.vertices.push_back(scale * words.vector());
    } else if (word == "f") {
      add_face(mesh, words);
    }
  }
  return mesh;
}

using Parser = MeshData (*)(std::string_view bytes, double scale);

std::variant<MeshData, std::string> guarded(Parser parser, std::string_view bytes, double scale) {
  try {
    return parser(bytes, scale);
  } catch (const MeshFileError& error) {
    return std::string(error.what());
  }
}

}  // namespace

std::variant<MeshData, std::string> read_stl(std::string_view bytes, double scale) {
  return guarded(&parse_stl, bytes, scale);
}

std::variant<MeshData, std::string> read_obj(std::string_view bytes, double scale) {
  return guarded(&parse_obj, bytes, scale);
}

std::variant<MeshData, std::string> read_mesh_file(const std::string& path, double scale) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  if (extension != ".stl" && extension != ".obj") return std::string("must be a mesh file, .stl or .obj");
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return std::string("does not exist");
  if (!std::filesystem::is_regular_file(status)) return std::string("is not a file");
  const auto size = std::filesystem::file_size(path, error);
  if (error) return "cannot be read: " + error.message();
  if (size > kLargestMeshFile)
    return fmt::format("is larger than {} MB, the limit for a mesh", kLargestMeshFile / 1'000'000);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  if (!file) return fmt::format("cannot be read: {}", std::strerror(errno));
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (file.gcount() != static_cast<std::streamsize>(size)) return std::string("cannot be read: input error");
  return extension == ".stl" ? read_stl(bytes, scale) : read_obj(bytes, scale);
}

}  // namespace netpocket
