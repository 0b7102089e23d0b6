#pragma once
// Films the window: a picture of it many times a second, encoded in the background.
//
// The video lasts as long as the filming did: where a picture comes late or encoding is behind, the one before stands
// longer. The window may change its size: its picture is fitted into the size that it had at first.
// Thread contract: the user interface's thread.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>

#include "gui/workbench/filming/film_writer.h"

namespace netpocket {

class WindowFilm : public QObject {
  Q_OBJECT
 public:
  explicit WindowFilm(QWidget& window);
  ~WindowFilm() override;  // finishes the video

  // Replaces a file that is there: whoever chose the path has been asked.
  void start(const QString& path, int pictures_per_second);
  // The file is whole when stopped() comes.
  void stop();
  // From start() until stopped() or failed().
  bool is_active() const { return writer_ != nullptr; }
  // Whether pictures are still taken; false while the video is being finished.
  bool is_filming() const { return timer_.isActive(); }
  double seconds() const;  // of the video so far
  // Pictures in whose place the one before stands longer.
  int left_out() const { return left_out_; }
  // Filming ends by itself when less is free on the disk, bytes.
  void set_least_free(qint64 bytes) { least_free_ = bytes; }

 signals:
  void state_changed();
  void second_passed();
  // `why` is empty, or one sentence when filming ended by itself. The file is whole.
  void stopped(const QString& path, double seconds, const QString& why);
  // One sentence. What was at the path before is still there.
  void failed(const QString& reason);

 private:
  void take_picture();
  bool disk_is_nearly_full() const;
  void end(const FilmEnd& result);

  QWidget& window_;
  QTimer timer_;
  QTimer seconds_timer_;
  QElapsedTimer clock_;
  QString path_;
  QString why_;
  int rate_ = 25;
  int taken_ = -1;    // index of the last picture
  int left_out_ = 0;  // so far
  qint64 least_free_;
  double length_ = 0;  // s, once filming has ended
  std::unique_ptr<FilmWriter> writer_;
};

}  // namespace netpocket
