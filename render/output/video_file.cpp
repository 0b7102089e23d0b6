#include "render/output/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "render/output/mp4_boxes.h"
#include "render/render_error.h"

namespace netpocket {
namespace {

std::vector<std::string> ffmpeg_arguments(int width, int height, double frames_per_second, VideoEffort effort,
                                          const std::string& path) {
  // The matrix is named because players guess it from the picture's size.
  const std::string filter = "scale=out_color_matrix=bt709:out_range=tv,pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:white";
  return {"ffmpeg",
          "-loglevel",
          "error",
          "-y",
          "-f",
          "rawvideo",
          "-pix_fmt",
          "rgb24",
          "-video_size",
          fmt::format("{}x{}", width, height),
          "-framerate",
          fmt::format("{}", frames_per_second),
          "-i",
          "pipe:0",
          "-vf",
          filter,
          "-c:v",
          "libx264",
          "-preset",
          effort == VideoEffort::live ? "superfast" : "medium",
          "-crf",
          "18",
          "-pix_fmt",
          "yuv420p",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "bt709",
          "-movflags",
          "+faststart",
          "-f",
          "mp4",
          "file:" + path};
}

std::string content(int file) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(0, lseek(file, 0, SEEK_END))), '\0');
  const ssize_t count = pread(file, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  return text;
}

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void replace_all(std::string& text, const std::string& old, const std::string& with) {
  for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + with.size())) {
    text.replace(at, old.size(), with);
  }
}

// The system's reason why a file cannot be written, where a line of ffmpeg's names one.
const char* reason_to_fail(const std::string& line) {
  for (const int error : {ENOSPC, EFBIG, EDQUOT, EIO, EROFS}) {
    if (line.find(std::strerror(error)) != line.npos) return std::strerror(error);
  }
  return nullptr;
}

}  // namespace

VideoFile::VideoFile(const std::string& path, int width, int height, double frames_per_second, VideoEffort effort)
    : file_(path, FileKind::video), bytes_(nullptr), width_(width), height_(height) {
  start(ffmpeg_arguments(width, height, frames_per_second, effort, file_.temporary_path()));
}

VideoFile::VideoFile(const std::string& page, std::string& bytes, int width, int height, double frames_per_second)
    : file_(page, FileKind::html), bytes_(&bytes), width_(width), height_(height) {
  start(ffmpeg_arguments(width, height, frames_per_second, VideoEffort::thorough, file_.temporary_path()));
}

VideoFile::~VideoFile() {
  if (process_ >= 0) {
    kill(process_, SIGTERM);
    wait();
  }
  close(messages_);
}

void VideoFile::start(const std::vector<std::string>& arguments) {
  messages_ = memfd_create("ffmpeg", MFD_CLOEXEC);
  // A socket rather than a pipe: sending on it can be told not to raise SIGPIPE when ffmpeg has gone.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw RenderError(fmt::format("cannot make a channel to ffmpeg: {}", std::strerror(errno)));
  }
  std::vector<char*> argv;
  for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, messages_, STDERR_FILENO);
  const int error = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  input_ = ends[0];
  if (error == 0) return;
  close(input_);
  close(std::exchange(messages_, -1));
  process_ = -1;
  throw RenderError(error == ENOENT
                        ? fmt::format("cannot make the video \"{}\": the program ffmpeg is not installed", file_.path())
                        : fmt::format("cannot start ffmpeg: {}", std::strerror(error)));
}

void VideoFile::write(const Image& image) {
  if (image.width != width_ || image.height != height_) {
    throw RenderError(fmt::format("cannot put a picture of {}x{} pixels into a video of {}x{}", image.width,
                                  image.height, width_, height_));
  }
  for (std::size_t sent = 0; sent < image.rgb.size();) {
    const ssize_t count = send(input_, image.rgb.data() + sent, image.rgb.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    sent += static_cast<std::size_t>(count);
  }
}

// Ffmpeg may end with success although the end of the file did not fit; its messages and the file tell.
void VideoFile::finish() {
  if (wait() != 0 || !messages().empty() || !is_whole_mp4(file_.temporary_path())) fail();
  if (bytes_ == nullptr) {
    file_.commit();
  } else {
    *bytes_ = content(file_.temporary_path());
  }
}

int VideoFile::wait() {
  close(input_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

std::vector<std::string> VideoFile::messages() const {
  std::vector<std::string> lines;
  std::istringstream text(content(messages_));
  for (std::string line; std::getline(text, line);) {
    replace_all(line, file_.temporary_path(), file_.path());
    lines.push_back(line);
  }
  return lines;
}

void VideoFile::fail() {
  if (process_ >= 0) wait();
  const auto lines = messages();
  for (const std::string& line : lines) {
    if (const char* reason = reason_to_fail(line)) throw write_error(file_.path(), reason);
  }
  throw RenderError(fmt::format("ffmpeg could not make the video \"{}\": {}", file_.path(),
                                lines.empty() ? "it gave no reason, and what it wrote is not whole" : lines.front()));
}

}  // namespace netpocket
