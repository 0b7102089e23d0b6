#include "gui/workbench/filming/window_film.h"

#include <QFileInfo>
#include <QStorageInfo>
#include <QWidget>
#include <cmath>

#include "gui/workbench/filming/window_picture.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

constexpr qint64 kLeastFree = qint64{64} << 20;  // bytes: enough to end the file properly

int even(int length) { return length + length % 2; }

}  // namespace

WindowFilm::WindowFilm(QWidget& window) : window_(window), least_free_(kLeastFree) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &WindowFilm::take_picture);
  seconds_timer_.setInterval(1000);
  connect(&seconds_timer_, &QTimer::timeout, this, [this] {
    emit second_passed();
    if (!disk_is_nearly_full()) return;
    why_ = tr("Recording the window has ended because the disk is nearly full; \"%1\" is whole.").arg(path_);
    stop();
  });
}

WindowFilm::~WindowFilm() {
  stop();
  writer_.reset();
}

void WindowFilm::start(const QString& path, int pictures_per_second) {
  if (is_active()) return;
  path_ = path;
  why_.clear();
  rate_ = pictures_per_second;
  taken_ = -1;
  left_out_ = 0;
  const QImage first = window_frame(window_);
  FilmFormat format{even(first.width()), even(first.height()), rate_, window_.palette().color(QPalette::Window)};
  writer_ = std::make_unique<FilmWriter>(path.toStdString(), format, [this](const FilmEnd& result) {
    QMetaObject::invokeMethod(
        this, [this, result] { end(result); }, Qt::QueuedConnection);
  });
  clock_.start();
  timer_.start(1000 / rate_);
  seconds_timer_.start();
  take_picture();
  emit state_changed();
}

double WindowFilm::seconds() const { return is_filming() ? 1e-3 * static_cast<double>(clock_.elapsed()) : length_; }

void WindowFilm::take_picture() {
  // To the nearest: a timer is now a little early, now a little late.
  const int index = static_cast<int>(std::lround(1e-3 * static_cast<double>(clock_.elapsed()) * rate_));
  if (index <= taken_ || !writer_->add(window_frame(window_), index)) return;
  left_out_ += index - taken_ - 1;
  taken_ = index;
}

bool WindowFilm::disk_is_nearly_full() const {
  const QStorageInfo disk(QFileInfo(path_).absolutePath());
  return disk.isValid() && disk.bytesAvailable() < least_free_;
}

void WindowFilm::stop() {
  if (!is_filming()) return;
  length_ = seconds();
  timer_.stop();
  seconds_timer_.stop();
  writer_->finish(std::max(1, static_cast<int>(std::lround(length_ * rate_))));
  emit state_changed();
}

void WindowFilm::end(const FilmEnd& result) {
  timer_.stop();
  seconds_timer_.stop();
  writer_.reset();
  emit state_changed();
  if (result.problem.empty()) {
    emit stopped(path_, result.seconds, why_);
  } else {
    emit failed(tr("The window's recording: %1").arg(engine_words(result.problem)));
  }
}

}  // namespace netpocket
