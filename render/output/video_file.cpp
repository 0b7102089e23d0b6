#include "render/output/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "render/render_error.h"

namespace netpocket {
namespace {

std::vector<std::string> ffmpeg_arguments(int width, int height, double frames_per_second, const std::string& path) {
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
          "medium",
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
          "file:" + path};
}

std::string first_line(std::FILE* file) {
  char line[400] = {};
  std::rewind(file);
  if (!std::fgets(line, sizeof line, file)) return "it gave no reason";
  line[std::strcspn(line, "\n")] = '\0';
  return line;
}

}  // namespace

VideoFile::VideoFile(const std::string& path, int width, int height, double frames_per_second)
    : file_(path), width_(width), height_(height), messages_(std::tmpfile(), std::fclose) {
  if (!messages_) throw RenderError(fmt::format("cannot make a temporary file: {}", std::strerror(errno)));
  start(ffmpeg_arguments(width, height, frames_per_second, file_.temporary_path()));
}

VideoFile::~VideoFile() {
  if (process_ < 0) return;
  kill(process_, SIGTERM);
  wait();
}

void VideoFile::start(const std::vector<std::string>& arguments) {
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
  posix_spawn_file_actions_adddup2(&actions, fileno(messages_.get()), STDERR_FILENO);
  const int error = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  input_ = ends[0];
  if (error == 0) return;
  close(input_);
  process_ = -1;
  throw RenderError(error == ENOENT
                        ? fmt::format("cannot make the video {}: the program ffmpeg is not installed", file_.path())
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

void VideoFile::finish() {
  if (wait() != 0) fail();
  file_.commit();
}

int VideoFile::wait() {
  close(input_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void VideoFile::fail() {
  if (process_ >= 0) wait();
  throw RenderError(fmt::format("ffmpeg could not make the video {}: {}", file_.path(), first_line(messages_.get())));
}

}  // namespace netpocket
