// Help, version, and what is said to a slip of the pen.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/gui/program.h"

namespace netpocket {
namespace {

const std::vector<std::string> kCommands = {"run",  "check",   "render",   "plot",  "report", "export",
                                            "info", "metrics", "findings", "study", "mesh",   "backends"};

TEST(CommandLine, WithoutArgumentsShowsHelp) {
  unsetenv("QT_QPA_PLATFORM");  // with which the workbench would open
  const auto result = run_program({});
  EXPECT_EQ(result.exit_code, 0);
  for (const std::string& command : kCommands) EXPECT_TRUE(contains(result.out, "\n  " + command + " ")) << command;
  EXPECT_EQ(result.error, "");
}

TEST(CommandLine, EveryCommandHasHelpWithExamplesAndExitCodes) {
  for (const std::string& command : kCommands) {
    const auto result = run_program({command, "--help"});
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_TRUE(contains(result.out, "Usage: netpocket " + command)) << result.out;
    EXPECT_TRUE(contains(result.out, "Examples:\n  netpocket " + command)) << result.out;
    EXPECT_TRUE(contains(result.out, "Exit codes:\n    0  done\n    2  wrong usage")) << result.out;
  }
}

TEST(CommandLine, VersionNamesLibraries) {
  const auto result = run_program({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  for (const char* part : {"netpocket 0.", "VTK 9.", "HDF5 1.", "Cairo 1."}) {
    EXPECT_TRUE(contains(result.out, part)) << result.out;
  }
}

TEST(CommandLine, BackendsSayWhatThereIs) {
  const auto result = run_program({"backends"});
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_TRUE(contains(result.out, "osmesa  ")) << result.out;
  EXPECT_TRUE(contains(result.out, "egl  ")) << result.out;
}

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& message) {
  SCOPED_TRACE(fmt::format("netpocket {}", fmt::join(arguments, " ")));
  const auto result = run_program(arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.error.starts_with("netpocket: ")) << result.error;
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  EXPECT_TRUE(contains(result.error, message)) << result.error;
}

TEST(CommandLine, WrongUsageIsOneSentenceAndStatus2) {
  struct Slip {
    std::vector<std::string> arguments;
    std::string message;  // part of what is said
  };
  const std::vector<Slip> slips = {
      {{"rnu"}, R"(unknown command "rnu"; did you mean "run"?)"},
      {{"simulate"}, R"(unknown command "simulate"; see netpocket --help)"},
      {{"--versoin"}, R"(did you mean "--version"?)"},
      {{"run"}, "SCENARIO is required"},
      {{"run", "a.toml"}, "--output is required"},
      {{"run", "a.toml", "--ouput", "b.h5"}, R"(unknown option "--ouput"; did you mean "--output"?)"},
      {{"run", "a.toml", "-x"}, R"(unknown option "-x")"},
      {{"run", "a.toml", "-o", "b.h5", "c.toml"}, "not expected: c.toml"},
      {{"run", "a.toml", "-o", "b.h5", "--until", "soon"}, R"(--until: "soon" is not a number above 0)"},
      {{"run", "a.toml", "-o", "b.h5", "--until", "nan"}, R"("nan" is not a number above 0)"},
      {{"run", "a.toml", "-o", "b.h5", "--until", "-1"}, R"("-1" is not a number above 0)"},
      {{"run", "a.toml", "-o", "b.h5", "--until", "0.0005"}, "--until: must be >= 0.001 and <= 100000 s, not 0.0005"},
      {{"render", "a.h5", "-o", "b", "--size", "20000x100"}, "and 16384 or less when multiplied by --supersampling"},
      {{"mesh"}, "MESH is required"},
      {{"mesh", "a.obj", "--thickness", "0.1"}, "--thickness needs --mend, the file to write"},
      {{"mesh", "a.obj", "--weld", "0.1"}, "--weld needs --mend, the file to write"},
      {{"mesh", "a.obj", "--mend", "b.ply"}, "must end in .stl or .obj"},
      {{"mesh", "a.obj", "--picture", "b.jpg"}, "ends with .png"},
      {{"mesh", "a.obj", "--unit", "mile"}, "use m, cm, mm"},
      {{"run", "a.toml", "-o", "b.h5", "--threads", "0"}, "not a whole number from 1 to 256"},
      {{"render", "a.h5"}, "give --output, --sheet, --video, --gltf or --save-view"},
      {{"render", "a.h5", "-o", "b", "--camera", "isso"}, R"(--camera: unknown name "isso"; did you mean "iso"?)"},
      {{"render", "a.h5", "-o", "b", "--camera", "bird"}, "use iso, side, front, mouth, follow"},
      {{"render", "a.h5", "-o", "b", "--backend", "osmessa"}, R"(did you mean "osmesa"?)"},
      {{"render", "a.h5", "-o", "b", "--color-by", "colour"}, "use none, tension, strain, speed"},
      {{"render", "a.h5", "-o", "b", "--size", "640"}, "not a size such as 1280x720"},
      {{"render", "a.h5", "-o", "b", "--size", "640x9"}, "not a size such as 1280x720"},
      {{"render", "a.h5", "-o", "b", "--times", "1,x"}, R"("x" is not a number)"},
      {{"render", "a.h5", "-o", "b", "--times", "1", "--fps", "5"}, "--times excludes --fps"},
      {{"plot", "a.h5", "-o", "b", "--figure", "figure05_froce"}, R"(did you mean "figure05_force"?)"},
      {{"plot", "a.h5", "-o", "b", "--format", "jpeg"}, R"(did you mean "png"?)"},
      {{"export", "a.h5"}, "nothing to write: give --csv"}};
  for (const Slip& slip : slips) expect_usage_error(slip.arguments, slip.message);
}

}  // namespace
}  // namespace netpocket
