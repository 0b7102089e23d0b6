// The target's shape from its scenario: meshes only from where the user allows, each fault in one sentence.

#include "engine/scenario/target_shape.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <variant>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "tests/engine/bodies/mesh_samples.h"

namespace netpocket {
namespace {

namespace fs = std::filesystem;

class TargetShapeTest : public testing::Test {
 protected:
  TargetShapeTest() {
    fs::create_directories(folder_ / "inside/meshes");
    write("inside/box.stl", samples::binary_stl(samples::box({2, 3, 4})));
    write("inside/meshes/box.obj", samples::obj(samples::moved(samples::box({200, 300, 400}), {700, 0, 0})));
    write("outside.stl", samples::binary_stl(samples::box({1, 1, 1})));
  }
  ~TargetShapeTest() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& bytes) {
    samples::write_file((folder_ / name).string(), bytes);
  }

  // A scenario read from inside/ that names this file.
  Scenario scenario(const std::string& mesh) {
    write("inside/own.toml", "[target]\nshape = \"mesh\"\nmesh_file = \"" + mesh + "\"\n");
    const ScenarioResult result = read_scenario_file((folder_ / "inside/own.toml").string());
    EXPECT_TRUE(result.ok()) << result.diagnostics.text();
    return result.scenario;
  }
  std::string problem(const Scenario& s) {
    const auto shape = target_shape(s);
    const auto* found = std::get_if<Diagnostic>(&shape);
    return found ? found->text() : "";
  }
  std::string problem_with(const std::string& mesh) { return problem(scenario(mesh)); }

  fs::path folder_ = fs::temp_directory_path() / ("netpocket_shape_" + std::to_string(getpid()));
};

TEST_F(TargetShapeTest, MeshesAreReadFromTheScenariosFolder) {
  const auto shape = target_shape(scenario("box.stl"));
  EXPECT_NEAR(volume(std::get<Shape>(shape)), 24, 1e-12);
  Scenario below = scenario("meshes/box.obj");
  below.target.mesh_unit = MeshUnit::centimetre;
  EXPECT_NEAR(volume(std::get<Shape>(target_shape(below))), 24, 1e-12);
  below.target.mesh_unit = MeshUnit::inch;
  EXPECT_NEAR(extents(std::get<Shape>(target_shape(below))).sizes().x(), 200 * 0.0254, 1e-12);
  EXPECT_EQ(problem_with("meshes/../box.stl"), "");
}

TEST_F(TargetShapeTest, NothingElseIsFollowed) {
  const std::string out = " leads out of the scenario's folder; only an absolute path on the command line may";
  EXPECT_EQ(problem_with("../outside.stl"), "target.mesh_file: \"../outside.stl\"" + out);
  EXPECT_EQ(problem_with("meshes/../../outside.stl"), "target.mesh_file: \"meshes/../../outside.stl\"" + out);
  fs::create_symlink(folder_ / "outside.stl", folder_ / "inside/link.stl");
  EXPECT_EQ(problem_with("link.stl"), "target.mesh_file: \"link.stl\"" + out);
  fs::create_directory_symlink(folder_, folder_ / "inside/up");
  EXPECT_EQ(problem_with("up/outside.stl"), "target.mesh_file: \"up/outside.stl\"" + out);
  const std::string absolute = (folder_ / "inside/box.stl").string();
  EXPECT_EQ(problem_with(absolute), "target.mesh_file: \"" + absolute +
                                        "\" is an absolute path, which only the command line may give: --set "
                                        "target.mesh_file=...");
  Scenario cut = scenario("box.stl");
  cut.target.mesh_file = std::string("box.stl\0.txt", 12);
  EXPECT_EQ(problem(cut), "target.mesh_file: \"box.stl\\u0000.txt\" is not a file's name");
  // A folder whose name begins like the scenario's is another folder.
  fs::create_directories(folder_ / "inside2");
  write("inside2/box.stl", samples::binary_stl(samples::box({1, 1, 1})));
  EXPECT_EQ(problem_with("../inside2/box.stl"), "target.mesh_file: \"../inside2/box.stl\"" + out);
}

TEST_F(TargetShapeTest, TheCommandLineMayNameAnyPath) {
  Scenario s = scenario("box.stl");
  ASSERT_TRUE(apply_setting(s, "target.mesh_file=" + (folder_ / "outside.stl").string()).ok());
  EXPECT_EQ(problem(s), "");
  EXPECT_NEAR(volume(std::get<Shape>(target_shape(s))), 1, 1e-12);
}

TEST_F(TargetShapeTest, BadMeshesHaveTheirSentence) {
  EXPECT_EQ(problem_with(""), "target.mesh_file: the shape \"mesh\" needs a file, .stl, .obj, .ply or .glb");
  EXPECT_EQ(problem_with("none.stl"), "target.mesh_file: \"none.stl\" does not exist");
  EXPECT_EQ(problem_with("own.toml"), "target.mesh_file: \"own.toml\" must be a mesh file, .stl, .obj, .ply or .glb");
  EXPECT_EQ(problem_with("meshes"), "target.mesh_file: \"meshes\" must be a mesh file, .stl, .obj, .ply or .glb");
  EXPECT_EQ(problem_with("meshes/box.obj"), "");
  MeshData open = samples::box({1, 1, 1});
  open.triangles.pop_back();
  write("inside/open.stl", samples::ascii_stl(open));
  EXPECT_TRUE(
      problem_with("open.stl").starts_with("target.mesh_file: \"open.stl\" is not watertight: 3 of its edges "));
  write("inside/cut.stl", "solid x\nvertex 1 2\n");
  EXPECT_EQ(problem_with("cut.stl"),
            "target.mesh_file: \"cut.stl\" cannot be read: line 2: a coordinate is not a number");
  Scenario loose = scenario("box.stl");
  loose.files = {};
  EXPECT_EQ(problem(loose),
            "target.mesh_file: \"box.stl\" is looked for in the scenario's folder, but the scenario has no file yet");
}

TEST_F(TargetShapeTest, AChangedFileIsReadAgain) {
  const Scenario s = scenario("box.stl");
  const auto mesh = [&] { return std::get<MeshShape>(std::get<Shape>(target_shape(s))).mesh; };
  const auto first = mesh();
  EXPECT_EQ(first, mesh());
  write("inside/box.stl", samples::binary_stl(samples::box({5, 5, 5})));
  fs::last_write_time(folder_ / "inside/box.stl", fs::file_time_type::clock::now() + std::chrono::seconds(2));
  EXPECT_NEAR(mesh()->volume(), 125, 1e-10);
}

TEST_F(TargetShapeTest, ChecksCountTheMesh) {
  EXPECT_EQ(check_scenario(scenario("box.stl")).text(), "");
  Scenario large = scenario("meshes/box.obj");
  large.target.mesh_unit = MeshUnit::foot;
  large.target.mesh_file = "meshes/box.obj";
  EXPECT_NE(check_scenario(large).text().find("inside the net"), std::string::npos);
}

TEST(SatelliteShape, NeedsPanelsBeyondTheBus) {
  Scenario s;
  s.target.shape = TargetShape::satellite;
  s.target.size = {2, 2.4, 2};
  EXPECT_EQ(check_scenario(s).text(), "");
  EXPECT_NEAR(extents(std::get<Shape>(target_shape(s))).sizes().x(), s.target.span, 1e-14);
  s.target.span = 2;
  EXPECT_EQ(check_scenario(s).text(), "target.span: must exceed the bus's edge along x, 2 m (target.size), not be 2 m");
}

TEST(TargetInertia, IsGivenOrThatOfTheShape) {
  Scenario s;
  s.target.inertia = {1, 2, 2.5};
  const Shape sphere = std::get<Shape>(target_shape(s));
  EXPECT_EQ(target_inertia(s.target, sphere)(1, 1), 2);
  s.target.inertia_from = InertiaSource::shape;
  s.target.inertia = {1, 2, 9};  // impossible, but not used
  EXPECT_NEAR(target_inertia(s.target, sphere)(1, 1), 0.4 * 200 * 4.5 * 4.5, 1e-10);
  EXPECT_EQ(check_scenario(s).text(), "");
}

}  // namespace
}  // namespace netpocket
