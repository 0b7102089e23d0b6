// netpocket mesh: what it says of files, draws and mends.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "tests/engine/bodies/mesh_samples.h"
#include "tests/gui/program.h"

namespace netpocket {
namespace {

using samples::box;
using samples::joined;
using samples::moved;
using samples::turned_inside_out;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

std::string write_obj(const TestFolder& folder, const MeshData& mesh) {
  return folder.write("body.obj", samples::obj(mesh));
}

void expect_fault(const MeshData& mesh, const std::string& sentence) {
  const TestFolder folder;
  const auto result = run_program({"mesh", write_obj(folder, mesh), "--unit", "m"});
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_TRUE(contains(result.out, "\nfault          " + sentence)) << result.out;
  EXPECT_TRUE(contains(result.error, sentence)) << result.error;
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
}

TEST(MeshCommand, TellsWhatABodyIs) {
  const TestFolder folder;
  MeshData data = joined(box({4000, 4000, 4000}), turned_inside_out(box({2000, 2000, 2000})));
  const auto result = run_program({"mesh", write_obj(folder, data)});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.error, "");
  for (const char* line :
       {"unit           mm (likely; --unit says another): 4 m large; in m 4000 m, in cm 40 m",
        "triangles      24, vertices 16", "extents        4 x 4 x 4 m, from (-2, -2, -2) m to (2, 2, 2) m",
        "parts          2", "part 1         12 triangles, 4 x 4 x 4 m about (0, 0, 0) m: 64 m^3",
        "part 2         12 triangles, 2 x 2 x 2 m about (0, 0, 0) m: hollow of 8 m^3", "volume         56 m^3",
        "centre of mass (0, 0, 0) m", "inertia        2.95238, 2.95238, 2.95238, I_xy 0", "faults         none"}) {
    EXPECT_TRUE(contains(result.out, line)) << line << "\nis not in\n" << result.out;
  }
}

TEST(MeshCommand, NamesEachFaultWithPlaces) {
  const MeshData cube = box({2, 2, 2});
  MeshData open = cube;
  open.triangles.pop_back();
  expect_fault(open, "is not watertight: 3 of its edges do not join exactly two triangles");
  expect_fault(joined(cube, moved(cube, {1, 0, 0})), "has parts that go through each other");
  expect_fault(joined(cube, box({1, 1, 1})), "has 1 part in the solid of another one that faces outwards");
  expect_fault(joined(cube, moved(turned_inside_out(cube), {5, 0, 0})), "has 1 part of 2 whose triangles face inwards");
  const TestFolder folder;
  const auto result = run_program({"mesh", write_obj(folder, open), "--unit", "m"});
  EXPECT_TRUE(contains(result.out, "\n  at           (1, -1, 0) m, ")) << result.out;
}

TEST(MeshCommand, MendsWhatIsUnambiguous) {
  const TestFolder folder;
  MeshData data = joined(box({2000, 2000, 2000}), moved(turned_inside_out(box({1000, 1000, 1000})), {3000, 0, 0}));
  for (const std::string name : {"mended.obj", "mended.stl"}) {
    const std::string mended = folder.file(name);
    const auto result = run_program({"mesh", write_obj(folder, data), "--mend", mended});
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_TRUE(contains(result.out, "\nmended         1 closed part turned to face outwards\n")) << result.out;
    EXPECT_TRUE(contains(result.out, "\nvolume         9 m^3\n")) << result.out;
    const auto again = run_program({"mesh", mended});
    EXPECT_EQ(again.exit_code, 0) << again.error;
    EXPECT_TRUE(contains(again.out, "unit           mm (likely")) << again.out;  // in the unit of the file
  }
}

TEST(MeshCommand, GivesOpenSurfacesAThickness) {
  const TestFolder folder;
  MeshData panel;
  panel.vertices = {{0, 0, 0}, {2000, 0, 0}, {2000, 1000, 0}, {0, 1000, 0}};
  panel.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto result = run_program(
      {"mesh", write_obj(folder, panel), "--unit", "mm", "--mend", folder.file("plate.obj"), "--thickness", "0.05"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(contains(result.out, "\nmended         1 open surface given a thickness of 0.05 m\n")) << result.out;
  EXPECT_TRUE(contains(result.out, "\nvolume         0.1 m^3\n")) << result.out;
}

// Both sides of the panel are there, cut along one diagonal each.
TEST(MeshCommand, GivesPanelsAThickness) {
  const TestFolder folder;
  MeshData panel;
  panel.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  for (const std::array<Triangle, 2>& back :
       {std::array<Triangle, 2>{{{0, 2, 1}, {0, 3, 2}}}, {{{1, 0, 3}, {1, 3, 2}}}}) {
    panel.triangles = {{0, 1, 2}, {0, 2, 3}, back[0], back[1]};
    const auto result = run_program(
        {"mesh", write_obj(folder, panel), "--unit", "m", "--mend", folder.file("plate.obj"), "--thickness", "0.05"});
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_TRUE(contains(result.out, "2 triangles left out, being the back of another")) << result.out;
    EXPECT_TRUE(contains(result.out, "\nvolume         0.1 m^3\n")) << result.out;
  }
}

TEST(MeshCommand, WhatCannotBeMendedIsSaid) {
  const TestFolder folder;
  const auto result = run_program(
      {"mesh", write_obj(folder, joined(box({4, 4, 4}), box({2, 2, 2}))), "--mend", folder.file("mended.obj")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(contains(result.out, "\nmended         nothing\n")) << result.out;
  EXPECT_TRUE(contains(result.error, "mended.obj\" has 1 part in the solid of another one")) << result.error;
}

TEST(MeshCommand, Draws) {
  const TestFolder folder;
  MeshData open = box({2, 2, 2});
  open.triangles.pop_back();
  const std::string picture = folder.file("body.png");
  const auto result = run_program({"mesh", write_obj(folder, open), "--picture", picture});
  EXPECT_EQ(result.exit_code, 3) << result.error;
  std::string signature(4, '\0');
  std::ifstream(picture, std::ios::binary).read(signature.data(), 4);
  EXPECT_EQ(signature, "\x89PNG");
}

TEST(MeshCommand, FilesThatHoldNoMesh) {
  const TestFolder folder;
  const auto error = [](const std::string& path) {
    const auto result = run_program({"mesh", path});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.out, "");
    return result.error;
  };
  EXPECT_TRUE(contains(error(folder.file("none.stl")), "none.stl\" does not exist"));
  EXPECT_TRUE(contains(error(folder.write("a.step", "")), "a.step\" is a CAD file with curved surfaces, not a mesh"));
  EXPECT_TRUE(contains(error(folder.write("a.3mf", "")), "a.3mf\" must be a mesh file, .stl, .obj, .ply or .glb"));
  EXPECT_TRUE(contains(error(folder.write("a.obj", "v 0 0 0\n")), "a.obj\" has no triangles"));
  EXPECT_TRUE(contains(error(folder.write("b.obj", "v nan 0 0\nf 1 1 1\n")), "coordinates are not finite numbers"));
}

}  // namespace
}  // namespace netpocket
