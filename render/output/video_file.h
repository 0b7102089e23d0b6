#pragma once
// An H.264 video in an MP4 file, encoded by the ffmpeg program from raw pictures on its standard input. The file
// appears under its name when it is finished. Thread contract: one thread at a time. Errors: throws RenderError with
// one sentence; when ffmpeg failed, with its reason.

#include <cstdio>
#include <memory>
#include <string>

#include "render/output/image.h"
#include "render/output/whole_file.h"

namespace netpocket {

class VideoFile {
 public:
  // Pictures are width x height pixels; odd sizes get a line of background, since the format wants even ones.
  VideoFile(const std::string& path, int width, int height, double frames_per_second);
  ~VideoFile();  // unless finished: stops ffmpeg and leaves no file
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  void write(const Image& image);
  void finish();

 private:
  void start(const std::vector<std::string>& arguments);
  // Waits for ffmpeg's end; its exit status.
  int wait();
  [[noreturn]] void fail();

  WholeFile file_;
  int width_;
  int height_;
  int input_ = -1;  // our end of ffmpeg's standard input
  pid_t process_ = -1;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> messages_;  // ffmpeg's standard error
};

}  // namespace netpocket
