#pragma once
// Plays recorded frames: which time is to be shown when. Knows nothing of windows.
// Thread contract: the user interface's thread.

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace netpocket {

class Playback : public QObject {
  Q_OBJECT
 public:
  explicit Playback(QObject* parent = nullptr);

  // The recorded stretch of time, s; may grow while it plays.
  void set_range(double begin, double end);
  // Where it is now, s; also while it plays.
  void set_time(double time);

  // Direction: 1 forwards, -1 backwards.
  void play(int direction);
  void stop();
  bool is_playing() const { return timer_.isActive(); }
  int direction() const { return direction_; }

  // Simulated seconds for one second of wall time.
  void set_speed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }
  void set_loop(bool loop) { loop_ = loop; }

 signals:
  void time_reached(double time);
  void playing_changed();

 private:
  void tick();
  // The time after one more step, wrapped or stopped at the ends.
  double limited(double time);

  QTimer timer_;
  QElapsedTimer clock_;
  double begin_ = 0;
  double end_ = 0;
  double time_ = 0;
  double speed_ = 1;
  int direction_ = 1;
  bool loop_ = false;
};

}  // namespace netpocket
