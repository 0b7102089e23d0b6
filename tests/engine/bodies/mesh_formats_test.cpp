// Meshes as PLY and binary glTF, good and bad.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "engine/bodies/mesh_file.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using MeshResult = std::variant<MeshData, std::string>;

std::string reason(const MeshResult& result) {
  const auto* text = std::get_if<std::string>(&result);
  return text ? *text : "";
}

double volume_of(const MeshResult& result) {
  EXPECT_EQ(reason(result), "");
  return samples::checked_mesh(std::get<MeshData>(result))->volume();
}

template <typename T>
std::string bytes_of(T value, bool reversed = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (reversed) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string ply_header(const std::string& format, const MeshData& mesh) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made up\nelement vertex {}\nproperty double x\nproperty uchar red\nproperty double "
      "y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, mesh.vertices.size(), mesh.triangles.size());
}

std::string binary_ply(const MeshData& mesh, bool big) {
  std::string text = ply_header(big ? "binary_big_endian" : "binary_little_endian", mesh);
  for (const Eigen::Vector3d& v : mesh.vertices) {
    text += bytes_of(v.x(), big) + "\x7f" + bytes_of(v.y(), big) + bytes_of(v.z(), big);
  }
  for (const Triangle& t : mesh.triangles) {
    text += '\3';
    for (const std::int32_t corner : t) text += bytes_of(corner, big);
  }
  return text;
}

std::string ascii_ply(const MeshData& mesh) {
  std::string text = ply_header("ascii", mesh);
  for (const Eigen::Vector3d& v : mesh.vertices) text += fmt::format("{} 127 {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

TEST(Ply, EveryEncodingGivesTheSameMesh) {
  const MeshData torus = samples::torus(3, 1, 24, 12);
  const double exact = samples::checked_mesh(torus)->volume();
  for (const std::string& file : {ascii_ply(torus), binary_ply(torus, false), binary_ply(torus, true)}) {
    EXPECT_NEAR(volume_of(read_ply(file, 1)), exact, 1e-12 * exact);
  }
  EXPECT_NEAR(volume_of(read_ply(ascii_ply(torus), 1e-1)), 1e-3 * exact, 1e-12 * exact);
}

// As other programs write it: other names of types, faces before edges, polygons, Windows line ends.
TEST(Ply, PolygonsAndOtherElements) {
  const std::string cube =
      "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement vertex 8\r\nproperty float32 x\r\nproperty float32 "
      "y\r\nproperty float32 z\r\nelement material 1\r\nproperty list uint8 float32 colour\r\nelement face "
      "6\r\nproperty uint8 group\r\nproperty list uint8 uint32 vertex_index\r\nend_header\r\n"
      "-1 -1 -1\r\n+1 -1 -1\r\n1 1 -1\r\n-1 1 -1\r\n-1 -1 1\r\n1 -1 1\r\n1 1 1\r\n-1 1 1\r\n3 0.5 0.5 0.5\r\n"
      "0 4 3 2 1 0\r\n0 4 4 5 6 7\r\n0 4 0 1 5 4\r\n0 4 2 3 7 6\r\n0 4 0 4 7 3\r\n0 4 1 2 6 5\r\n";
  EXPECT_NEAR(volume_of(read_ply(cube, 1)), 8, 1e-14);
}

TEST(Ply, BadFilesHaveTheirSentence) {
  const auto ply = [](const std::string& text) { return reason(read_ply(text, 1)); };
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n",
                    whole = vertices + "property float z\nelement face 1\nproperty list uchar int vertex_indices\n" +
                            "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(ply(""), "is empty");
  EXPECT_EQ(ply("solid\n"), "is not PLY: it does not begin with \"ply\"");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\n"), "is not PLY, or is cut off: its header has no end");
  EXPECT_EQ(ply("ply\nend_header\n"), "is not PLY: its header has no format");
  EXPECT_EQ(ply("ply\nformat zip 1.0\n"), "cannot be read: line 2: the format is neither ASCII nor binary");
  EXPECT_EQ(ply("ply\nproperty float x\n"), "cannot be read: line 2: a property belongs to no element");
  EXPECT_EQ(ply("ply\nelement vertex -1\n"), "cannot be read: line 2: an element needs a name and a number");
  EXPECT_EQ(ply("ply\nelement vertex 1\nproperty text x\n"),
            "cannot be read: line 3: the type of a property is not known");
  EXPECT_EQ(ply(vertices + "end_header\n0 0\n0 0\n0 0\n"), "cannot be read: its vertices have no z");
  EXPECT_EQ(ply(whole), "is cut off: it ends before all elements of its header");
  EXPECT_EQ(ply(whole + "3 0 1 3\n"), "cannot be read: a face names a vertex that does not exist (face 1)");
  EXPECT_EQ(ply(whole + "3 0 1 -1\n"), "cannot be read: a face names a vertex that does not exist (face 1)");
  EXPECT_EQ(ply(whole + "2 0 1\n"), "cannot be read: a face has fewer than three corners (face 1)");
  EXPECT_EQ(ply(whole + "3 0 x 1\n"), "cannot be read: line 13: a value is not a number");
  EXPECT_EQ(ply(whole + "-1\n"), "cannot be read: line 13: a list has no length");
  EXPECT_EQ(ply(whole + "100000 1\n"), "cannot be read: line 13: a face has more than 4096 corners");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nproperty float y\nproperty "
                "float z\nend_header\n"),
            "has more than the 2000000 triangles that are allowed");
}

// A binary glTF file of this JSON, in which @ stands for the number of bytes of `binary`.
std::string glb(std::string json, std::string binary) {
  binary.resize((binary.size() + 3) / 4 * 4);
  for (auto at = json.find('@'); at != json.npos; at = json.find('@')) {
    json.replace(at, 1, std::to_string(binary.size()));
  }
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto chunk = [](const std::string& type, const std::string& content) {
    return bytes_of(static_cast<std::uint32_t>(content.size())) + type + content;
  };
  const std::string chunks = chunk("JSON", json) + chunk(std::string("BIN\0", 4), binary);
  return "glTF" + bytes_of(2U) + bytes_of(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

// The mesh with its points first and corners of type T after them; nodes as given.
template <typename T>
std::string glb_of(const MeshData& mesh, const std::string& nodes, int type) {
  std::string points, corners;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (int c = 0; c < 3; ++c) points += bytes_of(static_cast<float>(v[c]));
  }
  for (const Triangle& t : mesh.triangles) {
    for (const std::int32_t corner : t) corners += bytes_of(static_cast<T>(corner));
  }
  const std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}},{{"attributes":{{"POSITION":0}},"mode":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},
{{"bufferView":1,"componentType":{},"count":{},"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":{}}},{{"buffer":0,"byteOffset":{},"byteLength":{}}}],
"buffers":[{{"byteLength":@}}]}})",
      nodes, mesh.vertices.size(), type, 3 * mesh.triangles.size(), points.size(), points.size(), corners.size());
  return glb(json, points + corners);
}

constexpr const char* kPlainNode = R"({"mesh":0})";

TEST(Glb, CornersOfEveryType) {
  const MeshData box = samples::box({1, 2, 3});
  EXPECT_NEAR(volume_of(read_glb(glb_of<std::uint8_t>(box, kPlainNode, 5121), 1)), 6, 1e-6);
  EXPECT_NEAR(volume_of(read_glb(glb_of<std::uint16_t>(box, kPlainNode, 5123), 1)), 6, 1e-6);
  EXPECT_NEAR(volume_of(read_glb(glb_of<std::uint32_t>(box, kPlainNode, 5125), 0.1)), 6e-3, 1e-9);
}

TEST(Glb, NodesPlaceTheirMeshes) {
  const MeshData box = samples::box({1, 2, 3});
  // A quarter turn about z, then a stretch that mirrors; below a node that moves.
  const std::string nodes =
      R"({"translation":[10,0,0],"children":[1,2]},
{"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[1,1,-2]},
{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,20,0,1]})";
  const MeshResult result = read_glb(glb_of<std::uint16_t>(box, nodes, 5123), 1);
  EXPECT_NEAR(volume_of(result), 18, 1e-5);
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& v : std::get<MeshData>(result).vertices) bounds.extend(v);
  EXPECT_LT((bounds.min() - Eigen::Vector3d(9, -0.5, -3)).norm(), 1e-6);
  EXPECT_LT((bounds.max() - Eigen::Vector3d(11, 21, 3)).norm(), 1e-6);
}

TEST(Glb, BadFilesHaveTheirSentence) {
  const auto problem = [](const std::string& text) { return reason(read_glb(text, 1)); };
  const std::string whole = glb_of<std::uint16_t>(samples::box({1, 2, 3}), kPlainNode, 5123);
  const auto edited = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    text.replace(text.find(from), from.size(), to);
    return problem(text);
  };
  EXPECT_EQ(problem(""), "is empty");
  EXPECT_EQ(problem("{\"asset\": 1}"), "is not binary glTF: it does not begin with \"glTF\"");
  EXPECT_EQ(problem("glTF" + bytes_of(1U) + bytes_of(12U)), "is not glTF 2.0: save it in that version");
  EXPECT_EQ(problem(whole.substr(0, 12)), "is cut off: a chunk of it is missing");
  EXPECT_EQ(problem(whole.substr(0, 100)), "is cut off: a chunk of it is shorter than it states");
  EXPECT_EQ(problem(whole.substr(0, whole.size() - 9)), "is cut off: a chunk of it is shorter than it states");
  EXPECT_EQ(edited("\"scene\":0", "\"scene\":7"), "cannot be read: it names scenes that do not exist");
  EXPECT_EQ(edited("\"mesh\":0", "\"mesh\":9"), "cannot be read: it names meshes that do not exist");
  EXPECT_EQ(edited("\"count\":8", "\"count\":9"), "is cut off: values of it lie behind its end");
  EXPECT_EQ(edited("\"count\":8", "\"count\":4"), "cannot be read: a face names a vertex that does not exist");
  EXPECT_EQ(edited("\"count\":8", "\"count\":-"), "is not glTF: what it says of itself is damaged");
  EXPECT_EQ(edited("{\"asset\"", "[\"asset\""), "is not glTF: what it says of itself is damaged");
  const std::string circle = R"({"children":[1]},{"children":[0],"mesh":0})";
  EXPECT_EQ(problem(glb_of<std::uint16_t>(samples::box({1, 2, 3}), circle, 5123)),
            "cannot be read: a node of it has two parents");
  EXPECT_EQ(problem(glb(R"({"extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[]})", "")),
            "is compressed (KHR_draco_mesh_compression): save it without compression");
}

// Whatever bytes a file has, it is a body or is refused in one sentence.
TEST(MeshFormats, RandomBytesDoNoHarm) {
  std::mt19937 random(11);
  const MeshData box = samples::box({1, 2, 3});
  const std::vector<std::string> files = {ascii_ply(box), binary_ply(box, false),
                                          glb_of<std::uint16_t>(box, kPlainNode, 5123)};
  int refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes = files[static_cast<std::size_t>(trial) % files.size()];
    for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    const MeshResult result = trial % 3 == 2 ? read_glb(bytes, 1) : read_ply(bytes, 1);
    if (const auto* data = std::get_if<MeshData>(&result)) {
      refused += std::holds_alternative<std::string>(TriangleMesh::make(*data));
    } else {
      EXPECT_FALSE(reason(result).empty());
      EXPECT_EQ(reason(result).find('\n'), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace netpocket
