#include "gui/workbench/filming/film_writer.h"

#include <QPainter>
#include <algorithm>
#include <cstdlib>
#include <exception>

#include "render/output/video_file.h"

namespace netpocket {
namespace {

constexpr std::size_t kMostWaiting = 12;  // pictures that encoding may be behind: half a second

bool nearly_as_large(const QSize& a, const QSize& b) {
  return std::abs(a.width() - b.width()) < 2 && std::abs(a.height() - b.height()) < 2;
}

}  // namespace

Image to_image(const QImage& picture) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  Image image{rgb.width(), rgb.height(), {}};
  image.rgb.reserve(image.row_bytes() * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    const uchar* row = rgb.constScanLine(y);
    image.rgb.insert(image.rgb.end(), row, row + image.row_bytes());
  }
  return image;
}

QImage fit_picture(const QImage& picture, const FilmFormat& format) {
  const QSize whole(format.width, format.height);
  if (picture.size() == whole) return picture;
  QImage canvas(whole, QImage::Format_RGB32);
  canvas.fill(format.ground);
  QImage fitted = picture;
  fitted.setDevicePixelRatio(1);
  if (!nearly_as_large(picture.size(), whole)) {
    fitted = fitted.scaled(whole, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  }
  QPainter(&canvas).drawImage(std::max(0, (whole.width() - fitted.width()) / 2),
                              std::max(0, (whole.height() - fitted.height()) / 2), fitted);
  return canvas;
}

FilmWriter::FilmWriter(const std::string& path, const FilmFormat& format, std::function<void(const FilmEnd&)> done)
    : path_(path), format_(format), done_(std::move(done)), frames_(kMostWaiting), thread_([this] { run(); }) {}

FilmWriter::~FilmWriter() {
  frames_.close();
  thread_.join();
}

bool FilmWriter::add(const QImage& picture, int index) { return frames_.try_push({picture, index}); }

void FilmWriter::finish(int count) {
  count_ = count;
  frames_.close();
}

void FilmWriter::run() {
  FilmEnd end;
  try {
    end.seconds = encode();
  } catch (const std::exception& error) {
    frames_.close();
    end.problem = error.what();
  }
  done_(end);
}

// Each picture is written when the next one tells how long it stood.
double FilmWriter::encode() {
  VideoFile video(path_, format_.width, format_.height, format_.rate, VideoEffort::live);
  Image shown;
  int written = 0;
  const auto write_until = [&](int index) {
    for (; written < index; ++written) video.write(shown);
  };
  while (const auto frame = frames_.pop()) {
    if (!shown.rgb.empty()) write_until(frame->index);
    shown = to_image(fit_picture(frame->picture, format_));
  }
  if (!shown.rgb.empty()) write_until(std::max(count_.load(), written + 1));
  video.finish();
  return static_cast<double>(written) / format_.rate;
}

}  // namespace netpocket
