#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "render/output/contact_sheet.h"
#include "render/output/png_file.h"
#include "render/output/video_file.h"
#include "render/render_error.h"
#include "tests/render/picture_checks.h"

namespace netpocket {
namespace {

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.rgb.push_back(static_cast<std::uint8_t>(x));
      image.rgb.push_back(static_cast<std::uint8_t>(y));
      image.rgb.push_back(static_cast<std::uint8_t>(x * y));
    }
  }
  return image;
}

Image plain(int width, int height, std::uint8_t level) {
  return {width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * height, level)};
}

std::array<int, 3> pixel(const Image& image, int x, int y) {
  const auto* rgb = image.rgb.data() + y * image.row_bytes() + 3 * x;
  return {rgb[0], rgb[1], rgb[2]};
}

std::string probe(const std::string& entries, const std::string& file) {
  const auto command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + entries + " -of csv=p=0 " + file;
  std::string text;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  for (int c; (c = std::fgetc(pipe.get())) != EOF && c != '\n';) text += static_cast<char>(c);
  return text;
}

TEST(Png, RoundTrip) {
  const auto file = pictures::folder("png") + "/gradient.png";
  const auto image = gradient(123, 77);
  write_png(image, file);
  const auto read = read_png(file);
  EXPECT_EQ(read.width, 123);
  EXPECT_EQ(read.height, 77);
  EXPECT_EQ(read.rgb, image.rgb);
}

// Noise does not compress: more bytes than are compressed at a time, which a smaller picture after it must not keep.
TEST(Png, OneWriterWritesPicturesOfAnySize) {
  Image noise{900, 700, {}};
  std::uint32_t state = 1;
  const auto next = [&] { return static_cast<std::uint8_t>((state = 1664525 * state + 1013904223) >> 24); };
  noise.rgb.resize(noise.row_bytes() * 700);
  std::ranges::generate(noise.rgb, next);
  Image clear = noise;
  clear.alpha.resize(900 * 700);
  std::ranges::generate(clear.alpha, next);
  PngWriter writer;
  const auto file = pictures::folder("png") + "/any.png";
  for (const auto& image : {noise, clear, gradient(5, 3), noise}) {
    writer.write(image, file, "a comment");
    const auto read = read_png(file);
    EXPECT_EQ(read.width, image.width);
    EXPECT_TRUE(read.rgb == image.rgb && read.alpha == image.alpha) << image.width;
    EXPECT_EQ(png_comment(file), "a comment");
  }
}

TEST(Png, LeavesNothingBehindWhenItCannotWrite) {
  try {
    write_png(plain(20, 20, 0), "/no/such/folder/picture.png");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "cannot write \"/no/such/folder/picture.png\": No such file or directory");
  }
  EXPECT_THROW(read_png("/no/such/folder/picture.png"), RenderError);
  const auto broken = pictures::folder("png") + "/broken.png";
  std::ofstream(broken) << "no picture";
  EXPECT_THROW(read_png(broken), RenderError);
}

TEST(ContactSheet, LaysOutPanels) {
  const SheetLayout layout{3, 10, 20};
  std::vector<SheetPanel> panels;
  for (int i = 0; i < 5; ++i) panels.push_back({plain(100, 60, static_cast<std::uint8_t>(40 * i)), "(a) t = 1 s"});
  const auto sheet = make_contact_sheet(panels, layout);
  write_png(sheet, pictures::folder("sheet") + "/plain.png");
  EXPECT_EQ(sheet.width, 10 + 3 * 110);
  EXPECT_EQ(sheet.height, 10 + 2 * (60 + 30 + 10));
  const std::array<int, 3> white = {255, 255, 255};
  for (int i = 0; i < 5; ++i) {
    const int left = 10 + i % 3 * 110, top = 10 + i / 3 * 100;
    const std::array<int, 3> level = {40 * i, 40 * i, 40 * i};
    EXPECT_EQ(pixel(sheet, left, top), level);
    EXPECT_EQ(pixel(sheet, left + 99, top + 59), level);
    EXPECT_EQ(pixel(sheet, left - 1, top), white);
    EXPECT_EQ(pixel(sheet, left, top - 1), white);
  }
  // The captions are written below the panels, and nothing where the sixth panel would be.
  Image below = plain(100, 30, 0), empty = plain(100, 90, 0);
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 100; ++x) {
      for (int c = 0; c < 3; ++c) {
        if (y < 30) below.rgb[y * below.row_bytes() + 3 * x + c] = pixel(sheet, 10 + x, 70 + y)[c];
        empty.rgb[y * empty.row_bytes() + 3 * x + c] = pixel(sheet, 230 + x, 110 + y)[c];
      }
    }
  }
  EXPECT_GT(pictures::drawn_fraction(below), 0.05);
  EXPECT_EQ(pictures::drawn_fraction(empty), 0);
}

TEST(ContactSheet, FillsItsLastRow) {
  const auto empty_cells = [](int panels, int columns) { return (columns - panels % columns) % columns; };
  for (int panels = 1; panels <= 60; ++panels) {
    const int columns = balanced_columns(panels, 1), rows = (panels + columns - 1) / columns;
    EXPECT_LE(empty_cells(panels, columns), std::max(1, 2 * columns / 5)) << panels << " panels in " << columns;
    EXPECT_GE(columns, rows - 1) << panels;
    EXPECT_LE(columns, std::max(3, 4 * rows)) << panels;
  }
  EXPECT_EQ(balanced_columns(4, 1), 2);
  EXPECT_EQ(balanced_columns(4, 16.0 / 9), 2);
  EXPECT_EQ(balanced_columns(4, 0.4), 4);  // tall panels
  EXPECT_EQ(balanced_columns(6, 1), 3);
  EXPECT_EQ(balanced_columns(7, 1), 4);
  EXPECT_EQ(balanced_columns(3, 1), 3);
}

TEST(ContactSheet, NeedsAPanel) {
  EXPECT_THROW(make_contact_sheet({}), RenderError);
  EXPECT_THROW(make_contact_sheet({{plain(4, 4, 0), ""}}, {0, 1, 1}), RenderError);
}

TEST(Video, HasItsSizeRateAndFrames) {
  const auto file = pictures::folder("video") + "/plain.mp4";
  std::filesystem::remove(file);
  VideoFile video(file, 101, 61, 25);  // odd: padded by one
  for (int i = 0; i < 12; ++i) video.write(plain(101, 61, static_cast<std::uint8_t>(20 * i)));
  EXPECT_FALSE(std::filesystem::exists(file));
  video.finish();
  EXPECT_EQ(probe("width,height,r_frame_rate,nb_read_frames", file), "102,62,25/1,12");
  EXPECT_THROW(VideoFile(file, 10, 10, 25).write(plain(12, 10, 0)), RenderError);
}

TEST(Video, UnfinishedLeavesNoFile) {
  const auto folder = pictures::folder("unfinished");
  {
    VideoFile video(folder + "/stopped.mp4", 64, 64, 25);
    video.write(plain(64, 64, 9));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(Video, SaysWhatFfmpegSaid) {
  const auto path = pictures::folder("video") + "/no_such_rate.mp4";
  try {
    VideoFile video(path, 64, 64, -1);
    for (int i = 0; i < 1000; ++i) video.write(plain(64, 64, 9));
    video.finish();
    FAIL();
  } catch (const RenderError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("ffmpeg could not make the video \"" + path + "\": "), std::string::npos) << text;
    EXPECT_NE(text.find("rate"), std::string::npos) << text;
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Video, NeedsItsFolder) { EXPECT_THROW(VideoFile("/no/such/folder/video.mp4", 64, 64, 25), FileError); }

TEST(Video, MissingFfmpegIsOneSentence) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/no/such/folder", 1);
  try {
    VideoFile video(pictures::folder("video") + "/missing.mp4", 64, 64, 25);
    ADD_FAILURE();
  } catch (const RenderError& error) {
    EXPECT_NE(std::string(error.what()).find("the program ffmpeg is not installed"), std::string::npos) << error.what();
  }
  setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace netpocket
