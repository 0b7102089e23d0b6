#include "engine/bodies/ply_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "engine/bodies/mesh_text.h"
#include "engine/bodies/polygon.h"

namespace netpocket {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes of big-endian files are reversed");

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyTypeName {
  std::string_view name, other;
  PlyType type;
  std::size_t bytes;
};
constexpr std::array kPlyTypes = {
    PlyTypeName{"char", "int8", PlyType::int8, 1},        PlyTypeName{"uchar", "uint8", PlyType::uint8, 1},
    PlyTypeName{"short", "int16", PlyType::int16, 2},     PlyTypeName{"ushort", "uint16", PlyType::uint16, 2},
    PlyTypeName{"int", "int32", PlyType::int32, 4},       PlyTypeName{"uint", "uint32", PlyType::uint32, 4},
    PlyTypeName{"float", "float32", PlyType::float32, 4}, PlyTypeName{"double", "float64", PlyType::float64, 8}};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

[[noreturn]] void refuse_header(int line, const std::string& problem) {
  throw MeshFileError(fmt::format("cannot be read: line {}: {}", line, problem));
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kSpace = " \t\r";
  for (std::size_t at = line.find_first_not_of(kSpace); at != line.npos; at = line.find_first_not_of(kSpace, at)) {
    const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

PlyType ply_type(std::string_view word, int line) {
  const auto type = std::ranges::find_if(kPlyTypes, [&](const auto& t) { return t.name == word || t.other == word; });
  if (type == kPlyTypes.end()) refuse_header(line, "the type of a property is not known");
  return type->type;
}

// Takes the header from the front of the bytes.
class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(std::string_view& bytes) : bytes_(bytes) {}

  PlyHeader read() {
    if (words_of(next_line()) != std::vector<std::string_view>{"ply"}) {
      throw MeshFileError("is not PLY: it does not begin with \"ply\"");
    }
    bool has_format = false;
    while (true) {
      const auto words = words_of(next_line());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format") {
        has_format = true;
        take_format(words);
      } else if (words[0] == "element") {
        take_element(words);
      } else if (words[0] == "property") {
        take_property(words);
      } else {
        refuse_header(line_, "this is no word of a PLY header");
      }
    }
    if (!has_format) throw MeshFileError("is not PLY: its header has no format");
    return std::move(header_);
  }

  int line() const { return line_; }

 private:
  std::string_view next_line() {
    ++line_;
    const std::size_t end = bytes_.find('\n');
    if (end == bytes_.npos) throw MeshFileError("is not PLY, or is cut off: its header has no end");
    const std::string_view line = bytes_.substr(0, end);
    bytes_.remove_prefix(end + 1);
    return line;
  }

  void take_format(const std::vector<std::string_view>& words) {
    const std::string_view name = words.size() > 1 ? words[1] : "";
    if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else if (name != "ascii") {
      refuse_header(line_, "the format is neither ASCII nor binary");
    }
  }

  void take_element(const std::vector<std::string_view>& words) {
    PlyElement element;
    const std::string_view digits = words.size() == 3 ? words[2] : "";
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), element.count);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) {
      refuse_header(line_, "an element needs a name and a number");
    }
    element.name = words[1];
    header_.elements.push_back(std::move(element));
  }

  void take_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) refuse_header(line_, "a property belongs to no element");
    const bool is_list = words.size() == 5 && words[1] == "list";
    if (!is_list && words.size() != 3) refuse_header(line_, "a property needs a type and a name");
    PlyProperty property{std::string(words.back()), ply_type(words[words.size() - 2], line_), {}};
    if (is_list) property.count_type = ply_type(words[2], line_);
    header_.elements.back().properties.push_back(std::move(property));
  }

  std::string_view& bytes_;
  PlyHeader header_;
  int line_ = 0;
};

// The numbers after the header, one by one.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view bytes, PlyEncoding encoding, int header_lines)
      : rest_(bytes), encoding_(encoding), line_(header_lines + 1) {}

  double next(PlyType type) { return encoding_ == PlyEncoding::ascii ? next_word() : next_bytes(type); }
  bool at_end() const { return rest_.empty(); }
  // " on line 7" in a text.
  std::string place() const { return encoding_ == PlyEncoding::ascii ? fmt::format("line {}: ", line_) : ""; }

 private:
  double next_word() {
    while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_.front()) != std::string_view::npos) {
      line_ += rest_.front() == '\n';
      rest_.remove_prefix(1);
    }
    if (rest_.empty()) refuse_end();
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
    rest_.remove_prefix(word.size());
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      throw MeshFileError(fmt::format("cannot be read: line {}: a value is not a number", line_));
    }
    return value;
  }

  double next_bytes(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return take<float>();
      case PlyType::float64:
        break;
    }
    return take<double>();
  }

  template <typename T>
  T take() {
    if (rest_.size() < sizeof(T)) refuse_end();
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), rest_.data(), sizeof(T));
    if (encoding_ == PlyEncoding::big_endian) std::ranges::reverse(bytes);
    rest_.remove_prefix(sizeof(T));
    return std::bit_cast<T>(bytes);
  }

  [[noreturn]] static void refuse_end() {
    throw MeshFileError("is cut off: it ends before all elements of its header");
  }

  std::string_view rest_;
  PlyEncoding encoding_;
  int line_;
};

class PlyBody {
 public:
  PlyBody(PlyNumbers numbers, double scale) : numbers_(numbers), scale_(scale) {}

  MeshData read(const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
      if (element.properties.empty()) continue;
      const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
      if (is_face) index_property_ = index_property_of(element);
      if (is_vertex) coordinates_ = coordinates_of(element);
      if (is_vertex) require_room_for_triangles(element.count / 3);
      for (std::size_t i = 0; i < element.count; ++i) {
        read_item(element);
        if (is_vertex)
          mesh_.vertices.push_back(
              scale_ * Eigen::Vector3d(values_[coordinates_[0]], values_[coordinates_[1]], values_[coordinates_[2]]));
        if (is_face) add_face(i);
      }
    }
    return std::move(mesh_);
  }

 private:
  static std::array<std::size_t, 3> coordinates_of(const PlyElement& element) {
    std::array<std::size_t, 3> places{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::string name(1, "xyz"[c]);
      const auto found = std::ranges::find(element.properties, name, &PlyProperty::name);
      if (found == element.properties.end() || found->count_type) {
        throw MeshFileError(fmt::format("cannot be read: its vertices have no {}", name));
      }
      places[c] = static_cast<std::size_t>(found - element.properties.begin());
    }
    return places;
  }

  static std::size_t index_property_of(const PlyElement& element) {
    const auto found = std::ranges::find_if(element.properties, [](const PlyProperty& property) {
      return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
    });
    if (found == element.properties.end()) throw MeshFileError("cannot be read: its faces have no vertex_indices");
    return static_cast<std::size_t>(found - element.properties.begin());
  }

  // Scalars to values_, the corners of a face to corners_.
  void read_item(const PlyElement& element) {
    values_.assign(element.properties.size(), 0.0);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (!property.count_type) {
        values_[p] = numbers_.next(property.type);
        continue;
      }
      const double count = numbers_.next(*property.count_type);
      if (!(count >= 0) || count > 1e9)
        throw MeshFileError(fmt::format("cannot be read: {}a list has no length", numbers_.place()));
      const bool is_corners = element.name == "face" && p == index_property_;
      if (is_corners) corners_.clear();
      if (is_corners && count > kMostPolygonCorners) {
        throw MeshFileError(
            fmt::format("cannot be read: {}a face has more than {} corners", numbers_.place(), kMostPolygonCorners));
      }
      for (double i = 0; i < count; ++i) {
        const double value = numbers_.next(property.type);
        if (is_corners) corners_.push_back(value);
      }
    }
  }

  void add_face(std::size_t face) {
    if (corners_.size() < 3) refuse_face(face, "a face has fewer than three corners");
    std::vector<std::int32_t> indices;
    std::vector<Eigen::Vector3d> places;
    for (const double corner : corners_) {
      if (!(corner >= 0) || corner >= static_cast<double>(mesh_.vertices.size())) {
        refuse_face(face, "a face names a vertex that does not exist");
      }
      indices.push_back(static_cast<std::int32_t>(corner));
      places.push_back(mesh_.vertices[static_cast<std::size_t>(indices.back())]);
    }
    const auto triangles = triangulate(places);
    if (const auto* problem = std::get_if<std::string>(&triangles)) refuse_face(face, *problem);
    for (const auto& [a, b, c] : std::get<CornerTriples>(triangles)) {
      require_room_for_triangles(mesh_.triangles.size() + 1);
      mesh_.triangles.push_back({indices[a], indices[b], indices[c]});
    }
  }

  [[noreturn]] void refuse_face(std::size_t face, const std::string& problem) const {
    throw MeshFileError(fmt::format("cannot be read: {} (face {})", problem, face + 1));
  }

  PlyNumbers numbers_;
  double scale_;
  MeshData mesh_;
  std::array<std::size_t, 3> coordinates_{};
  std::size_t index_property_ = 0;
  std::vector<double> values_, corners_;
};

}  // namespace

MeshData parse_ply(std::string_view bytes, double scale) {
  if (bytes.empty()) throw MeshFileError("is empty");
  PlyHeaderReader reader(bytes);
  const PlyHeader header = reader.read();
  return PlyBody(PlyNumbers(bytes, header.encoding, reader.line()), scale).read(header);
}

}  // namespace netpocket
