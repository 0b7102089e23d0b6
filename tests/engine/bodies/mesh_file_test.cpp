// Mesh files, good and bad.

#include "engine/bodies/mesh_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "tests/engine/bodies/mesh_samples.h"
#include "tests/hardening/hardening_table.h"

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
  EXPECT_EQ(stl("hello"), "is not STL: it does not begin with \"solid\" and is too short for a binary file");
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

TEST(MeshFile, ReasonsAreTrue) {
  const std::string whole = samples::binary_stl(samples::box({1, 1, 1}));
  EXPECT_EQ(problem(read_stl(whole + "xy", 1)),
            "is not STL, or is longer than it says: 12 triangles, as it states, take 684 bytes, and it has 686");
  EXPECT_EQ(problem(read_stl(whole.substr(0, 600), 1)),
            "is not STL, or is cut off: 12 triangles, as it states, take 684 bytes, and it has 600");
  const std::string utf16(
      "\xff\xfe"
      "v\0 \0",
      6);
  EXPECT_EQ(problem(read_obj(utf16, 1)), "is text in UTF-16, which mesh files are not: save it as UTF-8");
  EXPECT_EQ(problem(read_stl(utf16, 1)), "is text in UTF-16, which mesh files are not: save it as UTF-8");
  EXPECT_EQ(problem(read_obj(whole, 1)), "is not a text: byte 82 is zero");
  EXPECT_EQ(problem(read_obj(samples::ascii_stl(samples::box({1, 1, 1})), 1)),
            "is not OBJ: line 1 begins with no word of that format");
}

TEST(MeshFile, ByteOrderMarkIsNoPartOfTheText) {
  const MeshData cube = samples::box({4, 4, 4});
  EXPECT_NEAR(volume(read_obj("\xef\xbb\xbf" + samples::obj(cube).substr(samples::obj(cube).find("v ")), 1)), 64,
              1e-12);
  EXPECT_NEAR(volume(read_stl("\xef\xbb\xbf" + samples::ascii_stl(cube), 1)), 64, 1e-12);
}

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) result += c == '\n' ? end : std::string(1, c);
  return result;
}

TEST(MeshFile, AnyLineEnds) {
  const MeshData cube = samples::box({4, 4, 4});
  for (const std::string end : {"\r", "\r\n", "\n\n"}) {
    EXPECT_NEAR(volume(read_obj(with_line_ends(samples::obj(cube), end), 1)), 64, 1e-12);
    EXPECT_NEAR(volume(read_stl(with_line_ends(samples::ascii_stl(cube), end), 1)), 64, 1e-12);
  }
  EXPECT_EQ(problem(read_obj("v 0 0 0\r\rv 0 0 x\r", 1)), "cannot be read: line 3: a coordinate is not a number");
}

TEST(MeshFile, ObjLinesThatGoOnAndCommentsBehind) {
  const std::string cube =
      "v 0 0 0 # first\nv 2 0 \\\n0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
      "f 4 3 2 1# bottom\nf 5 6 \\\r\n7 8 # top\nf 1 2 6\\\n 5\n#f 1 2 3 \\\nf 3 4 8 7\nf 1 5 8 4\nf 2 3 7 6\n";
  EXPECT_NEAR(volume(read_obj(cube, 1)), 8, 1e-14);
  EXPECT_EQ(problem(read_obj("v 0 0 0\nv 1 \\\n0 \\\nx\n", 1)), "cannot be read: line 4: a coordinate is not a number");
}

TEST(MeshFile, StlAsProgramsWriteIt) {
  const MeshData cube = samples::box({4, 4, 4});
  const std::string plain = samples::ascii_stl(cube);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = plain;
    for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return volume(read_stl(text, 1));
  };
  EXPECT_NEAR(replaced("endloop", "end loop"), 64, 1e-12);
  EXPECT_NEAR(replaced("endfacet", "end facet"), 64, 1e-12);
  EXPECT_NEAR(replaced("  facet", "  color 0.5 0.5 1\n  facet"), 64, 1e-12);
  EXPECT_NEAR(replaced("normal 0 0 0", "normal nan -nan(ind) inf"), 64, 1e-12);
  EXPECT_NEAR(replaced("solid sample", "solid my own solid facets"), 64, 1e-12);
  EXPECT_NEAR(replaced("\n", " "), 64, 1e-12);  // one line
  EXPECT_NEAR(replaced("vertex", "VERTEX"), 64, 1e-12);
  const std::string two = with_line_ends(plain + samples::ascii_stl(samples::moved(cube, {9, 0, 0})), " ");
  EXPECT_NEAR(volume(read_stl(two, 1)), 128, 1e-12);
}

// A U of 3 x 3 with a coordinate of 1 x 2, as one face, drawn out by 1: 7 m^3.
std::string channel(const std::string& front, const std::string& back) {
  std::string text;
  const int outline[8][2] = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  for (const int z : {0, 1}) {
    for (const auto& [x, y] : outline) text += fmt::format("v {} {} {}\n", x, y, z);
  }
  text += front + "\n" + back + "\n";
  for (int i = 0; i < 8; ++i) {
    const int next = (i + 1) % 8;
    text += fmt::format("f {} {} {} {}\n", i + 1, next + 1, next + 9, i + 9);
  }
  return text;
}

TEST(MeshFile, FacesThatAreNotConvexKeepTheirShape) {
  const Result result = read_obj(channel("f 8 7 6 5 4 3 2 1", "f 9 10 11 12 13 14 15 16"), 1);
  ASSERT_EQ(problem(result), "");
  const auto mesh = samples::checked_mesh(std::get<MeshData>(result));
  EXPECT_NEAR(mesh->volume(), 7, 1e-14);
  // The square of 3 x 3 less the coordinate of 1 x 2 about (1.5, 2).
  const double y = (9 * 1.5 - 2 * 2) / 7;
  EXPECT_NEAR(mesh->centre_in_file().y(), y, 1e-14);
  const double xx = 7 * 1.0 / 12 + 9 * 9 / 12.0 + 9 * 1.5 * 1.5 - (2 * 4 / 12.0 + 2 * 4) - 7 * y * y;  // of z^2 + y^2
  EXPECT_NEAR(mesh->unit_inertia()(0, 0), xx / 7, 1e-13);
  // In the coordinate is outside.
  EXPECT_NEAR(mesh->nearest(Eigen::Vector3d(1.5, 2.5, 0.5) - mesh->centre_in_file()).distance, 0.5, 1e-14);
  // From any corner on.
  for (int first = 0; first < 8; ++first) {
    std::string front = "f", back = "f";
    for (int i = 0; i < 8; ++i) {
      front += fmt::format(" {}", 8 - (first + i) % 8);
      back += fmt::format(" {}", 9 + (first + i) % 8);
    }
    EXPECT_NEAR(volume(read_obj(channel(front, back), 1)), 7, 1e-14);
  }
}

TEST(MeshFile, FacesThatAreNotPlaneAreRefusedWithTheirLine) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv 1 1 0.0001\n";
  EXPECT_EQ(problem(read_obj(corners + "f 1 2 \\\n3 4\n", 1)),
            "cannot be read: line 6: a face is not plane: a corner lies 0.018 of its extent off its plane (0.001 is "
            "allowed); export it as triangles");
  EXPECT_EQ(problem(read_obj(corners + "f 1 2 5 4\n", 1)), "");
  EXPECT_EQ(problem(read_obj("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", 1)),
            "cannot be read: line 5: a face crosses itself");
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

TEST(MeshFile, AnEndOfNothingIsRefused) {
  for (const char* text : {"solid x\nend\n", "solid x\nfacet\nend\nloop\n", "solid x\nend"}) {
    EXPECT_NE(problem(read_stl(text, 1)).find("this is not STL"), std::string::npos) << text;
  }
}

TEST(MeshFileHardening, DamagedFilesDoNoHarm) {
  const MeshData box = samples::box({1, 1, 1});
  std::mt19937 random(5);
  const int trials = test::trial_count(600, 100000);
  int refused = 0;
  for (int trial = 0; trial < trials; ++trial) {
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
  EXPECT_GT(refused, trials / 6);
  EXPECT_TRUE(test::record_hardening(
      {"STL or OBJ file with one to four random bytes", std::to_string(trials) + " files",
       std::to_string(refused) + " refused in one sentence, the others are bodies: no harm done"}));
}

TEST(MeshFile, PlacesThatHoldNoMesh) {
  const std::string folder = std::filesystem::temp_directory_path() / ("netpocket_mesh_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder + "/folder.stl");
  const auto read = [&](const std::string& name) { return problem(read_mesh_file(folder + "/" + name, 1)); };
  EXPECT_EQ(read("missing.stl"), "does not exist");
  EXPECT_EQ(read("folder.stl"), "is not a file");
  EXPECT_EQ(read("mesh.3mf"), "must be a mesh file, .stl, .obj, .ply or .glb");
  EXPECT_NE(read("mesh.STEP").find("make an STL file of it"), std::string::npos);
  EXPECT_EQ(read("mesh.gltf"), "is glTF in several files: save it as one binary file, .glb");
  EXPECT_EQ(problem(read_mesh_file("/dev/zero", 1)), "must be a mesh file, .stl, .obj, .ply or .glb");
  samples::write_file(folder + "/empty.obj", "");
  EXPECT_EQ(std::get<MeshData>(read_mesh_file(folder + "/empty.obj", 1)).triangles.size(), 0u);
  samples::write_file(folder + "/BOX.STL", samples::binary_stl(samples::box({1, 1, 1})));
  EXPECT_EQ(read("BOX.STL"), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace netpocket
