// Where outputs go: nothing that is not to be replaced is destroyed, links lead on, permissions stay.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "engine/recording/recording.h"
#include "tests/gui/output_commands.h"

namespace netpocket {
namespace {

using namespace test;

class Outputs : public OutputTest {
 protected:
  // Refused with status 2, and the file is as it was.
  void expect_kept(const Words& command, const std::string& path, const Words& parts) const {
    const std::string before = content(path);
    expect_sentence(run_program(command), 2, parts);
    EXPECT_EQ(content(path), before) << path;
  }
};

TEST_F(Outputs, LeaveFilesOfAnotherKind) {
  const std::string other = folder_.file("other.h5");
  std::filesystem::copy_file(recording_, other);
  const std::string named_html = folder_.file("b.html"), bare = folder_.file("recording"),
                    view_place = folder_.file("v");
  for (const std::string& copy : {named_html, bare}) std::filesystem::copy_file(recording_, copy);
  const std::string scenario = folder_.write("mine.toml", content(scenario_file("case1.toml")));
  const std::string text = folder_.write("notes", "my notes\n");
  std::filesystem::copy_file(scenario, view_place);

  expect_kept({"render", "--sheet", other, recording_}, other, {"--sheet: ", "names another format", "ends with .png"});
  expect_kept({"report", recording_, "-o", other}, other, {"--output: ", "ends with .html"});
  expect_kept(report(named_html), named_html, {named_html, "is an HDF5 file, such as a recording"});
  expect_kept(gltf(other), other, {"--gltf: ", "ends with .glb"});
  expect_kept(gltf(bare), bare, {bare, "an HDF5 file", "a binary glTF scene would destroy"});
  expect_kept(view(other), other, {"--save-view: ", "ends with .toml"});
  expect_kept(view(scenario), scenario, {scenario, "a TOML file, such as a scenario", "a view would destroy"});
  expect_kept(view(view_place), view_place, {view_place, "a TOML file"});
  expect_kept(video(text), text, {text, "a text file of another kind", "an MP4 video would destroy"});
  expect_kept(run_words(text) + Words{"--overwrite"}, text, {text, "a recording would destroy"});
  expect_kept({"study", scenario_file("studies/findings.toml"), "-o", folder_.file("study"), "--report", scenario},
              scenario, {"--report: ", "ends with .md"});
}

TEST_F(Outputs, LeaveForeignFilesInTheirFolders) {
  const auto taken = [&](const std::string& folder, const std::string& name) {
    std::filesystem::create_directory(folder_.file(folder));
    std::filesystem::copy_file(recording_, folder_.file(folder + "/" + name));
    return folder_.file(folder + "/" + name);
  };
  const std::string table = taken("csv", "channels.csv"), series = taken("vtp", "netpocket.pvd"),
                    mesh = taken("meshes", "lines_0000.vtp"), figure = taken("figures", "figure03_closing.svg"),
                    picture = taken("frames", "0000.png");
  expect_kept({"export", recording_, "--csv", folder_.file("csv")}, table, {table, "a CSV table"});
  expect_kept({"export", recording_, "--vtp", folder_.file("vtp"), "--quiet"}, series, {series});
  expect_kept({"export", recording_, "--vtp", folder_.file("meshes"), "--quiet"}, mesh, {mesh});
  expect_kept({"plot", recording_, "-o", folder_.file("figures"), "--figure", "figure03_closing", "--format", "svg"},
              figure, {figure});
  expect_kept({"render", recording_, "-o", folder_.file("frames"), "--times", "0", "--size", "64x64", "--quiet"},
              picture, {picture});
}

TEST_F(Outputs, AreNoInputs) {
  const std::string scenario = folder_.write("s.toml", content(scenario_file("case1.toml")));
  const std::string link = folder_.file("link"), hard = folder_.file("hard");
  std::filesystem::create_symlink(recording_, link);
  std::filesystem::create_hard_link(recording_, hard);
  for (const std::string& name : {link, hard}) {
    expect_kept(report(name), recording_, {"is the same file as", "which is read"});
  }
  expect_kept({"run", "--resume", hard, "--until", "0.2", "--overwrite", "-o", scenario}, scenario, {"--output: "});
  expect_kept({"run", scenario, "-o", scenario, "--overwrite"}, scenario, {"ends with .h5"});
  const std::string bare = folder_.write("scenario", content(scenario));
  expect_kept({"run", bare, "-o", bare, "--overwrite"}, bare, {"is the same file as", bare});
  const std::string view = folder_.file("view");
  ASSERT_EQ(run_program({"render", recording_, "--save-view", view}).exit_code, 0);
  expect_kept({"render", recording_, "--view", view, "--save-view", view}, view, {"is the same file as"});
}

TEST_F(Outputs, HaveOneFileEach) {
  const std::string path = folder_.file("x"), frames = folder_.file("frames");
  const auto both = run_program({"render", recording_, "--times", "0", "--sheet", path, "--gltf", folder_.file("./x")});
  expect_sentence(both, 2, {"--gltf: ", "is the file that --sheet names"});
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::create_symlink("x", folder_.file("y"));
  expect_sentence(run_program({"render", recording_, "--sheet", path, "--video", folder_.file("y")}), 2, {"--video: "});
  const auto inside = run_program({"render", recording_, "-o", frames, "--sheet", frames + "/0003.png"});
  expect_sentence(inside, 2, {"is one of the files that --output writes"});
}

TEST_F(Outputs, AreNotWhatTheShellWritesTo) {
  const std::string path = folder_.write("new.h5.log", "");
  const auto result = run_program(run_words(folder_.file("new.h5")), {.out = path});
  expect_sentence(result, 2, {"the log: ", path, "standard output"});
  EXPECT_FALSE(std::filesystem::exists(folder_.file("new.h5")));
}

TEST_F(Outputs, OfTheSameKindAreReplaced) {
  const std::string png = folder_.file("a.png"), html = folder_.file("a.html"), toml = folder_.file("a.toml");
  for (int i = 0; i < 2; ++i) {
    for (const Words& command : {sheet(png), report(html), view(toml), run_words(recording_) + Words{"--overwrite"}}) {
      const auto result = run_program(command);
      EXPECT_EQ(result.exit_code, 0) << result.error;
    }
  }
  folder_.write("empty.png", "");
  EXPECT_EQ(run_program(sheet(folder_.file("empty.png"))).exit_code, 0);
}

TEST_F(Outputs, FollowLinks) {
  std::filesystem::create_directory(folder_.file("store"));
  const auto linked = [&](const std::string& name) {
    std::filesystem::create_symlink("store/" + name, folder_.file(name));
    return folder_.file(name);
  };
  const std::string recorded = linked("new.h5");
  for (const Words& command :
       {sheet(linked("a.png")), gltf(linked("a.glb")), view(linked("a.toml")), report(linked("a.html")),
        run_words(recorded), run_words(recorded) + Words{"--overwrite"},
        Words{"run", "--resume", recorded, "--until", "0.2", "--quiet"}}) {
    const auto result = run_program(command);
    EXPECT_EQ(result.exit_code, 0) << result.error;
  }
  for (const std::string name : {"a.png", "a.glb", "a.toml", "a.html", "new.h5"}) {
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.file(name))) << name;
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_.file("store/" + name))) << name;
  }
  EXPECT_NEAR(Recording(folder_.file("store/new.h5")).times().back(), 0.2, 1e-6);
}

TEST_F(Outputs, AreRegularFiles) {
  const std::string pipe = folder_.file("pipe"), device = folder_.file("device");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/null", device);
  for (const auto& [path, what] : {std::pair(pipe, "it is a pipe"), {device, "it is a device"}}) {
    for (const Words& command :
         {sheet(path), gltf(path), view(path), report(path), video(path), run_words(path) + Words{"--overwrite"}}) {
      expect_sentence(run_program(command), 5, {path, what});
    }
  }
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_TRUE(std::filesystem::is_symlink(device));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(Outputs, KeepPermissions) {
  const std::string png = folder_.file("a.png"), toml = folder_.file("a.toml");
  const std::vector<std::pair<std::string, Words>> outputs = {
      {png, sheet(png)},
      {toml, view(toml)},
      {recording_, run_words(recording_) + Words{"--overwrite"}},
      {recording_, {"run", "--resume", recording_, "--until", "0.2", "--quiet"}}};
  for (const auto& [path, command] : outputs) {
    if (path != recording_) {
      ASSERT_EQ(run_program(command).exit_code, 0);
    }
    ASSERT_EQ(chmod(path.c_str(), 0640), 0);
    const auto result = run_program(command);
    EXPECT_EQ(result.exit_code, 0) << result.error;
    EXPECT_EQ(mode_of(path), 0640u) << path;
  }
}

TEST_F(Outputs, LeaveReadOnlyFiles) {
  const std::string png = folder_.file("a.png");
  ASSERT_EQ(run_program(sheet(png)).exit_code, 0);
  for (const std::string& path : {png, recording_}) ASSERT_EQ(chmod(path.c_str(), 0444), 0);
  const std::string picture = content(png), recorded = content(recording_);
  expect_sentence(run_program(sheet(png)), 5, {png, "read-only"});
  const Words resume = {"run", "--resume", recording_, "--until", "0.2", "--quiet"};
  expect_sentence(run_program(resume), 5, {recording_, "read-only", "--overwrite"});
  EXPECT_EQ(content(png), picture);
  EXPECT_EQ(content(recording_), recorded);
  const auto result = run_program(resume + Words{"--overwrite"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(mode_of(recording_), 0444u);
}

TEST_F(Outputs, HaveNamesAsLongAsTheSystemAllows) {
  const auto named = [&](std::size_t bytes, const std::string& suffix) {
    return folder_.file(std::string(bytes - suffix.size(), 'n') + suffix);
  };
  const auto expect_done = [](const Words& command) {
    const auto result = run_program(command);
    EXPECT_EQ(result.exit_code, 0) << result.error;
  };
  for (const std::size_t bytes : {240, 250}) {
    expect_done(sheet(named(bytes, ".png")));
    expect_done(gltf(named(bytes, ".glb")));
    expect_done(view(named(bytes, ".toml")));
    expect_done(report(named(bytes, ".html")));
    expect_done(video(named(bytes, ".mp4")));
    expect_done(run_words(named(bytes, ".h5")));
  }
  expect_done(sheet(named(255, ".png")));
  const std::string too_long = named(300, ".png");
  expect_sentence(run_program(sheet(too_long)), 5, {too_long, "File name too long"});
  expect_sentence(run_program(run_words(named(300, ".h5"))), 5, {"File name too long"});
  expect_sentence(run_program({"info", named(300, ".h5")}), 5, {"File name too long"});
  expect_sentence(run_program({"check", named(300, ".toml")}), 5, {"File name too long"});
}

TEST_F(Outputs, OfLoopsOfLinksAreOneSentence) {
  const std::string loop = folder_.file("loop");
  std::filesystem::create_symlink("loop", loop);
  const Words commands[] = {sheet(loop),
                            report(loop),
                            run_words(loop),
                            {"info", loop},
                            {"metrics", loop},
                            {"check", loop},
                            {"study", loop, "-o", folder_.file("s")},
                            {"export", recording_, "--csv", loop},
                            {"plot", recording_, "-o", loop},
                            {"render", recording_, "-o", loop},
                            {"study", scenario_file("studies/findings.toml"), "-o", loop},
                            {"render", recording_, "--view", loop, "--sheet", folder_.file("a.png")}};
  for (const Words& command : commands) {
    expect_sentence(run_program(command), 5, {loop, "Too many levels of symbolic links"});
  }
}

TEST_F(Outputs, NeedNoTemporaryFolder) {
  for (const std::string place : {"TMPDIR=", "TMPDIR=/no/such/folder"}) {
    for (const Words& command : {Words{"report", recording_, "-o", folder_.file("a.html"), "--fps", "20", "--quiet"},
                                 video(folder_.file("a.mp4"))}) {
      const auto result = run_program(command, {.environment = {place}});
      EXPECT_EQ(result.exit_code, 0) << place << ": " << result.error;
    }
  }
}

// The log of a recording is that recording's alone.
TEST_F(Outputs, LogsAreOfOneRecordingEach) {
  const std::string one = folder_.file("run_0.5"), other = folder_.file("run_0.7");
  folder_.write("run_0.log", "mine\n");
  for (const std::string& path : {one, other}) ASSERT_EQ(run_program(run_words(path)).exit_code, 0);
  EXPECT_EQ(content(folder_.file("run_0.log")), "mine\n");
  for (const std::string& path : {one, other}) {
    const std::string log = content(path + ".log");
    EXPECT_TRUE(contains(log, "recorded in \"" + path + "\"")) << log;
  }
  EXPECT_FALSE(contains(content(one + ".log"), other));
  ASSERT_EQ(run_program(run_words(one) + Words{"--overwrite"}).exit_code, 0);
  const std::string twice = content(one + ".log");
  EXPECT_LT(twice.find("command: "), twice.rfind("command: "));
}

TEST_F(Outputs, LogsOfOthersAreNotTouched) {
  const std::string log = folder_.write("new.h5.log", "[table]\nname = \"a scenario\"\n");
  expect_sentence(run_program(run_words(folder_.file("new.h5"))), 2, {log, "a log of netpocket would destroy"});
  EXPECT_EQ(content(log), "[table]\nname = \"a scenario\"\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("new.h5")));
}

}  // namespace
}  // namespace netpocket
