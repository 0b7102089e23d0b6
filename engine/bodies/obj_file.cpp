#include "engine/bodies/obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "engine/bodies/mesh_text.h"
#include "engine/bodies/polygon.h"

namespace netpocket {
namespace {

// All keywords of the format except "v" and "f".
constexpr std::string_view kOtherWords[] = {
    "vt",        "vn",     "vp",     "p",    "l",     "fo",     "g",     "s",        "o",        "mg",   "mtllib",
    "usemtl",    "usemap", "maplib", "curv", "curv2", "surf",   "parm",  "trim",     "hole",     "scrv", "sp",
    "end",       "con",    "deg",    "bmat", "step",  "cstype", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj",
    "trace_obj", "ctech",  "stech",  "call", "csh",   "bsp",    "bzp",   "cdc",      "cdp",      "res"};

class ObjFile {
 public:
  ObjFile(std::string_view text, double scale) : words_(text, '#'), scale_(scale) {}

  MeshData parse() {
    while (words_.next_line()) {
      const std::string_view word = words_.next();
      if (word == "v") {
        require_room_for_triangles(mesh_.vertices.size() / 3);
        mesh_.vertices.push_back(scale_ * words_.vector());
      } else if (word == "f") {
        add_face();
      } else if (!word.empty() && unknown_line_ == 0 &&
                 std::find(std::begin(kOtherWords), std::end(kOtherWords), word) == std::end(kOtherWords)) {
        unknown_line_ = words_.line();
      }
    }
    if (mesh_.triangles.empty() && unknown_line_ > 0) {
      throw MeshFileError(fmt::format("is not OBJ: line {} begins with no word of that format", unknown_line_));
    }
    return std::move(mesh_);
  }

 private:
  // Vertex index of a word such as "7", "7/1", "7//3" or "-1". Only the first number counts. It is 1-based, or negative
  // to count backwards from the newest vertex.
  std::int32_t corner(std::string_view word) const {
    const std::string_view digits = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) words_.fail("a corner of a face is not a number");
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t index = number < 0 ? count + number : number - 1;
    if (index < 0 || index >= count) words_.fail("a face names a vertex that does not exist");
    return static_cast<std::int32_t>(index);
  }

  // Removes corners at the same place as the one before them.
  static void drop_repeated(std::vector<std::int32_t>& corners, std::vector<Eigen::Vector3d>& places) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (places[i] == places[(i + corners.size() - 1) % corners.size()]) continue;
      corners[kept] = corners[i];
      places[kept++] = places[i];
    }
    corners.resize(kept);
    places.resize(kept);
  }

  void add_face() {
    const int line = words_.line();
    std::vector<std::int32_t> corners;
    std::vector<Eigen::Vector3d> places;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      corners.push_back(corner(word));
      places.push_back(mesh_.vertices[corners.back()]);
    }
    if (corners.size() < 3) MeshWords::fail("a face has fewer than three corners", line);
    drop_repeated(corners, places);
    if (corners.size() < 3) return;
    const auto triangles = triangulate(places);
    if (const auto* problem = std::get_if<std::string>(&triangles)) MeshWords::fail(*problem, line);
    for (const auto& [a, b, c] : std::get<CornerTriples>(triangles)) {
      require_room_for_triangles(mesh_.triangles.size() + 1);
      mesh_.triangles.push_back({corners[a], corners[b], corners[c]});
    }
  }

  MeshWords words_;
  double scale_;
  MeshData mesh_;
  int unknown_line_ = 0;  // first line that is not OBJ; 0: none
};

}  // namespace

MeshData parse_obj(std::string_view bytes, double scale) { return ObjFile(plain_text(bytes), scale).parse(); }

}  // namespace netpocket
