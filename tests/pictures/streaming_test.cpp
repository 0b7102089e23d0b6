// How `netpocket render` goes through many pictures: interrupted, taken up again, in bounded memory.

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <set>
#include <thread>

#include "render/output/png_file.h"
#include "tests/gui/program.h"
#include "tests/pictures/made_up_recordings.h"

namespace netpocket::pictures {
namespace {

namespace fs = std::filesystem;

class Streaming : public testing::Test {
 protected:
  Streaming() { write_pocket_recording(run_); }

  std::vector<std::string> arguments(const std::string& pictures_per_second) const {
    return {"render", run_, "-o", out_, "--fps", pictures_per_second, "--size", "320x240", "--backend", "osmesa"};
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(out_)) names.insert(entry.path().filename());
    return names;
  }

  TestFolder folder_;
  std::string run_ = folder_.file("run.h5"), out_ = folder_.file("out");
};

TEST_F(Streaming, InterruptedLeavesWholePicturesAndResumes) {
  auto command = arguments("100");  // 1001 pictures of 10 s: enough to be interrupted in
  command.insert(command.end(), {"--video", folder_.file("video.mp4")});
  RunningProgram program(command);
  while (!fs::exists(out_ + "/0003.png")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
  const auto left = files();
  ASSERT_LT(left.size(), 1001u);
  for (const auto& name : left) EXPECT_EQ(read_png(out_ + "/" + name).width, 320) << name;
  EXPECT_TRUE(left.contains("0000.png"));
  EXPECT_FALSE(fs::exists(folder_.file("video.mp4"))) << "half a video";
  for (const auto& entry : fs::directory_iterator(fs::path(run_).parent_path())) {
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
  }

  // Of the pictures that are there, one is taken as it is and the missing are drawn.
  const auto first = fs::last_write_time(out_ + "/0000.png");
  auto again = arguments("1");
  again.emplace_back("--resume");
  EXPECT_EQ(run_program(again).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(out_ + "/0000.png"), first);
  EXPECT_EQ(read_png(out_ + "/0010.png").width, 320);
}

TEST_F(Streaming, ProgressNamesThePictureAndTheTimeLeft) {
  const auto result = run_program(arguments("1"));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.error.find("picture 11 of 11"), std::string::npos) << result.error;
  EXPECT_NE(result.error.find(" left"), std::string::npos) << result.error;
}

// Thirty times as many pictures may take a twentieth more memory: one picture of this size, drawn, is 1.2 MB, the
// program 200 MB.
TEST_F(Streaming, MemoryDoesNotGrowWithTheNumberOfPictures) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer holds back what is freed";
#endif
  const auto peak = [&](const char* rate) {
    RunningProgram program(arguments(rate));
    const auto result = program.wait();
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return result.peak_memory;
  };
  const double few = peak("1"), many = peak("30");
  EXPECT_LT(many, 1.05 * few) << few << " and " << many << " kB";
}

}  // namespace
}  // namespace netpocket::pictures
