// Mesh files, good and bad.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "engine/bodies/mesh_file.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

using Result = std::variant<MeshData, std::string>;

std::string problem(const Result& result) {
  const auto* text = std::get_if<std::string>(&result);
  return text ? *text : "";
}

double volume(const Result& result) { return samples::checked_mesh(std::get<MeshData>(result))->volume(); }

TEST(MeshFile, AllFormatsGiveTheSameMesh) {
  const MeshData torus = samples::torus(3, 1, 24, 12);
  const double exact = samples::checked_mesh(torus)->volume();
  EXPECT_NEAR(volume(read_stl(samples::binary_stl(torus), 1)), exact, 1e-6 * exact);  // single precision
  EXPECT_NEAR(volume(read_stl(samples::ascii_stl(torus), 1)), exact, 1e-13 * exact);
  EXPECT_NEAR(volume(read_obj(samples::obj(torus), 1)), exact, 1e-13 * exact);
  EXPECT_NEAR(volume(read_obj(samples::obj(torus), 1e-1)), 1e-3 * exact, 1e-13 * exact);
}

TEST(MeshFile, ObjPolygonsAndTheirKindsOfCorners) {
  const std::string cube =
      "mtllib ../../secret.mtl\nv -1 -1 -1 1.0\nv +1 -1 -1\nv 1 1 -1\nv -1 1 -1\r\n"
      "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nvn 0 0 1\nvt 0 0\nusemtl steel\ns off\n"
      "f 4 3 2 1\nf 5/1 6/1 7/1 8/1\nf 1//1 2//1 6//1 5//1\nf 3/1/1 4/1/1 8/1/1 7/1/1\nf -8 -4 -1 -5\nf 2 3 7 6\n";
  const Result result = read_obj(cube, 1);
  EXPECT_EQ(std::get<MeshData>(result).triangles.size(), 12u);
  EXPECT_NEAR(volume(result), 8, 1e-14);
}

TEST(MeshFile, BadTextsHaveTheirSentence) {
  const auto stl = [](const std::string& text) { return problem(read_stl(text, 1)); };
  const auto obj = [](const std::string& text) { return problem(read_obj(text, 1)); };
  EXPECT_EQ(stl(""), "is empty");
  EXPECT_EQ(stl("hello"), "is not STL, or is cut off: its length does not fit its number of triangles");
  EXPECT_EQ(stl("solid x\n facet normal 0 0 1\n outer loop\n vertex 0 0 zero\n"),
            "cannot be read: line 4: a coordinate is not a number");
  EXPECT_EQ(stl("solid x\nvertex 0 0\n"), "cannot be read: line 2: a coordinate is not a number");
  EXPECT_EQ(stl("solid x\nvertex 0 0 0\nendfacet\nendsolid\n"),
            "cannot be read: line 3: a facet has fewer than three vertices");
  EXPECT_EQ(stl("solid x\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\n"),
            "cannot be read: line 5: a facet has more than three vertices");
  EXPECT_EQ(stl("solid x\nfacet\n"), "is cut off: \"endsolid\" is missing");
  EXPECT_EQ(stl("solid x\n<html>\n"), "cannot be read: line 2: this is not STL");
  EXPECT_EQ(obj("v 0 0 0\nf 1 2 3\n"), "cannot be read: line 2: a face names a vertex that does not exist");
  EXPECT_EQ(obj("v 0 0 0\nf 0 1 1\n"), "cannot be read: line 2: a face names a vertex that does not exist");
  EXPECT_EQ(obj("v 0 0 0\nf 1 1\n"), "cannot be read: line 2: a face has fewer than three corners");
  EXPECT_EQ(obj("v 0 0 0\nf 1 x 1\n"), "cannot be read: line 2: a corner of a face is not a number");
  EXPECT_EQ(obj("v 0 1e999 0\n"), "cannot be read: line 1: a coordinate is not a number");
  // Numbers that are none pass here, and are refused with the mesh.
  EXPECT_TRUE(std::get<MeshData>(read_obj("v nan 0 0\n", 1)).vertices[0].hasNaN());
}

TEST(MeshFile, CutOffBinaryStlIsRefused) {
  const std::string whole = samples::binary_stl(samples::box({1, 1, 1}));
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(problem(read_stl(whole.substr(0, length), 1)), "");
  EXPECT_EQ(problem(read_stl(whole, 1)), "");
  std::string lying = whole.substr(0, 84);
  lying.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_NE(problem(read_stl(lying, 1)), "");
}

TEST(MeshFile, DamagedFilesDoNoHarm) {
  const MeshData box = samples::box({1, 1, 1});
  std::mt19937 random(5);
  int refused = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::string bytes = trial % 3 == 0   ? samples::binary_stl(box)
                        : trial % 3 == 1 ? samples::ascii_stl(box)
                                         : samples::obj(box);
    for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    const Result result = trial % 3 == 2 ? read_obj(bytes, 1) : read_stl(bytes, 1);
    if (const auto* data = std::get_if<MeshData>(&result)) {
      const auto mesh = TriangleMesh::make(*data);
      if (std::holds_alternative<std::string>(mesh)) ++refused;
    } else {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(MeshFile, PlacesThatHoldNoMesh) {
  const std::string folder = std::filesystem::temp_directory_path() / ("netpocket_mesh_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder + "/folder.stl");
  const auto read = [&](const std::string& name) { return problem(read_mesh_file(folder + "/" + name, 1)); };
  EXPECT_EQ(read("missing.stl"), "does not exist");
  EXPECT_EQ(read("folder.stl"), "is not a file");
  EXPECT_EQ(read("mesh.step"), "must be a mesh file, .stl or .obj");
  EXPECT_EQ(problem(read_mesh_file("/dev/zero", 1)), "must be a mesh file, .stl or .obj");
  samples::write_file(folder + "/empty.obj", "");
  EXPECT_EQ(std::get<MeshData>(read_mesh_file(folder + "/empty.obj", 1)).triangles.size(), 0u);
  samples::write_file(folder + "/BOX.STL", samples::binary_stl(samples::box({1, 1, 1})));
  EXPECT_EQ(read("BOX.STL"), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace netpocket
