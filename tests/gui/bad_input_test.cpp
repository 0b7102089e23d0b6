// Files and settings that cannot be used: one sentence, the right status, nothing half-written.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

void expect_refusal(const std::vector<std::string>& arguments, int exit_code, const std::string& message) {
  const auto result = run_program(arguments);
  EXPECT_EQ(result.exit_code, exit_code) << result.error;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.error.starts_with("netpocket: ")) << result.error;
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  EXPECT_NE(result.error.find(message), result.error.npos) << result.error;
}

TEST(BadInput, MisspeltKeyIsNamedWithItsLineAndTheNearestKey) {
  const TestFolder folder;
  const std::string scenario = folder.write("own.toml", "[net]\ndiametr = 0.004\n");
  const std::string output = folder.file("run.h5");
  expect_refusal({"run", scenario, "-o", output}, 3, "own.toml:2: ");
  expect_refusal({"run", scenario, "-o", output}, 3, "net.diameter");
  EXPECT_FALSE(std::filesystem::exists(output));
}

// It is told, and no fault.
TEST(BadInput, KeysWithoutEffectAreMentioned) {
  const TestFolder folder;
  const std::string scenario =
      folder.write("own.toml", "[target]\nradius = 4.0\nlength = 5\n[towing]\nmode = \"none\"\n");
  const auto result = run_program({"check", scenario, "--set", "solver.seed=7"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(contains(result.error, "own.toml:3: target.length: has no effect: Used for cylinders")) << result.error;
  EXPECT_TRUE(contains(result.error, "solver.seed: has no effect: Used with a perturbation")) << result.error;
  EXPECT_FALSE(contains(result.error, "radius") || contains(result.error, "towing")) << result.error;
  for (const char* sound : {"case1.toml", "thrown_net.toml", "pocket_on_tether.toml"}) {
    EXPECT_EQ(run_program({"check", scenario_file(sound)}).error, "") << sound;
  }
}

TEST(BadInput, StringForNumber) {
  const TestFolder folder;
  expect_refusal({"check", folder.write("own.toml", "[net]\ndiameter = \"4 mm\"\n")}, 3, "number in m");
}

TEST(BadInput, ScenarioThatMakesNoSense) {
  const TestFolder folder;
  expect_refusal({"check", folder.write("own.toml", "[closing]\nclosed_length = 50\n")}, 3, "closing.closed_length");
}

TEST(BadInput, EveryProblemIsSaid) {
  const TestFolder folder;
  const auto result = run_program({"check", folder.write("own.toml", "[net]\ndiametr = 1\ndensity = \"a\"\n")});
  EXPECT_EQ(result.exit_code, 3);
  for (const char* part : {"netpocket: ", "own.toml:2: ", "\nnetpocket: ", "own.toml:3: "}) {
    EXPECT_NE(result.error.find(part), result.error.npos) << result.error;
  }
}

TEST(BadInput, TextThatIsNoToml) {
  const TestFolder folder;
  expect_refusal({"check", folder.write("own.toml", "[net\n")}, 3, "own.toml:1: ");
}

TEST(BadInput, Settings) {
  const std::string scenario = scenario_file("case1.toml");
  expect_refusal({"check", scenario, "--set", "net.diametr=1"}, 3, "did you mean");
  expect_refusal({"check", scenario, "--set", "net.diameter=thick"}, 3, "number");
  expect_refusal({"check", scenario, "--set", "net.diameter"}, 3, "--set");
  expect_refusal({"check", scenario, "--set", "net.diameter=-1"}, 3, "net.diameter");
}

TEST(BadInput, Meshes) {
  const TestFolder folder;
  const auto own = [&](const std::string& mesh) {
    return folder.write("own.toml", "[target]\nshape = \"mesh\"\nmesh_file = \"" + mesh + "\"\n");
  };
  expect_refusal({"check", own("none.stl")}, 3, "target.mesh_file: \"none.stl\" does not exist");
  expect_refusal({"check", own("../../etc/x.stl")}, 3, "leads out of the scenario's folder");
  expect_refusal({"check", own("/etc/x.stl")}, 3, "only the command line may give");
  expect_refusal({"check", own(""), "--set", "target.mesh_file=/no/such.stl"}, 3, "\"/no/such.stl\" does not exist");
  folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_refusal({"check", own("bad.obj")}, 3, "\"bad.obj\" is not watertight: 3 of its edges");
}

TEST(BadInput, ARecordingIsNoScenario) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  expect_refusal({"check", recording}, 3, "is a recording, not a scenario: see netpocket info");
  expect_refusal({"run", recording, "-o", folder.file("b.h5")}, 3, "is a recording, not a scenario");
}

TEST(BadInput, FilesOfOtherKindsAreCalledWhatTheyAre) {
  const TestFolder folder;
  const std::string recording = short_recording(folder), output = folder.file("out");
  const std::pair<std::string, std::string> files[] = {
      {folder.write("a.png", "\x89PNG\r\n\x1a\n...."), "is a PNG picture, not a "},
      {folder.write("cube.obj", "v 0 0 0\nv 1 0 0\n"), "is an OBJ mesh, not a "},
      {folder.write("page.html", "<!doctype html>\n"), "is an HTML page, not a "}};
  for (const auto& [path, sentence] : files) {
    expect_refusal({"check", path}, 3, sentence + "scenario");
    expect_refusal({"study", path, "-o", output}, 3, sentence + "study");
  }
  expect_refusal({"study", recording, "-o", output}, 3, "is an HDF5 file, such as a recording, not a study");
  expect_refusal({"study", scenario_file("case1.toml"), "-o", output}, 3, "is a scenario, not a study");
}

TEST(BadInput, MissingFilesAndFolders) {
  const TestFolder folder;
  const std::string missing = folder.file("missing"), place = folder.file("");
  expect_refusal({"check", missing}, 3, "no such file");
  expect_refusal({"check", place}, 3, "folder");
  for (const std::string& input : {missing, place, scenario_file("case1.toml")}) {
    expect_refusal({"info", input}, 3, input);
    expect_refusal({"metrics", input}, 3, input);
    expect_refusal({"findings", input}, 3, input);
    expect_refusal({"plot", input, "-o", folder.file("figures")}, 3, input);
    expect_refusal({"render", input, "-o", folder.file("frames")}, 3, input);
    expect_refusal({"export", input, "--csv", folder.file("csv")}, 3, input);
  }
  EXPECT_TRUE(folder.empty());
}

TEST(BadInput, TimeOutsideTheRecording) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  expect_refusal({"render", recording, "-o", folder.file("frames"), "--times", "0,5"}, 2, "5 s is outside");
  EXPECT_FALSE(std::filesystem::exists(folder.file("frames")));
}

TEST(BadOutput, PlacesThatCannotBeWritten) {
  const TestFolder folder;
  const std::string recording = short_recording(folder);
  const std::string file = folder.write("file", "");
  const std::string inside_file = file + "/inside", nowhere = folder.file("no/folder/file");
  const std::string scenario = scenario_file("case1.toml");
  for (const std::string& output : {nowhere, inside_file}) {
    expect_refusal({"run", scenario, "-o", output, "--until", "0.1"}, 5, output);
    expect_refusal({"render", recording, "--sheet", output}, 5, output);
    expect_refusal({"render", recording, "--video", output}, 5, output);
  }
  expect_refusal({"run", scenario, "-o", folder.file("")}, 5, "folder");
  for (const std::string& output : {file, inside_file}) {
    expect_refusal({"plot", recording, "-o", output}, 5, output);
    expect_refusal({"render", recording, "-o", output}, 5, output);
    expect_refusal({"export", recording, "--csv", output}, 5, output);
    expect_refusal({"export", recording, "--vtp", output}, 5, output);
  }
}

TEST(BadOutput, FullStandardOutputIsNoticed) {
  const auto result = run_program({"--version"}, {.out = "/dev/full"});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_NE(result.error.find("standard output"), result.error.npos) << result.error;
}

}  // namespace
}  // namespace netpocket
