#pragma once
// An H.264 video in an MP4 file, encoded by the ffmpeg program from raw pictures on its standard input. The file
// appears under its name when it is finished and was found to be whole. Thread contract: one thread at a time. Errors:
// FileError where the file does not fit or cannot be written; otherwise RenderError with one sentence; when ffmpeg
// failed, with its reason.

#include <string>
#include <vector>

#include "engine/base/whole_file.h"
#include "render/output/image.h"

namespace netpocket {

// Small files, or as quickly as pictures of a screen come while other things go on.
enum class VideoEffort { thorough, live };

class VideoFile {
 public:
  // Pictures are width x height pixels; odd sizes get a line of background, since the format wants even ones.
  VideoFile(const std::string& path, int width, int height, double frames_per_second,
            VideoEffort effort = VideoEffort::thorough);
  // The video as a part of the HTML page `page`, in whose folder ffmpeg writes a temporary file; finish() fills
  // `bytes`.
  VideoFile(const std::string& page, std::string& bytes, int width, int height, double frames_per_second);
  ~VideoFile();  // unless finished: stops ffmpeg and leaves no file
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  void write(const Image& image);
  void finish();

 private:
  void start(const std::vector<std::string>& arguments);
  // Waits for ffmpeg's end; its exit status.
  int wait();
  // What ffmpeg said, with the file's own name for the temporary one.
  std::vector<std::string> messages() const;
  [[noreturn]] void fail();

  WholeFile file_;
  std::string* bytes_;  // null: a file of its own
  int width_;
  int height_;
  int input_ = -1;  // our end of ffmpeg's standard input
  pid_t process_ = -1;
  int messages_ = -1;  // ffmpeg's standard error, in memory
};

}  // namespace netpocket
