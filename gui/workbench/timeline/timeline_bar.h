#pragma once
// The strip of time with the buttons that play it.

#include <QWidget>

#include "gui/workbench/action_icons.h"
#include "gui/workbench/session/capture_session.h"
#include "gui/workbench/timeline/playback.h"
#include "gui/workbench/timeline/timeline_strip.h"

class QAction;
class QComboBox;
class QLabel;

namespace netpocket {

class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  // The session must outlive the bar.
  explicit TimelineBar(CaptureSession& session, QWidget* parent = nullptr);

  TimelineStrip* strip() const { return strip_; }
  Playback& playback() { return playback_; }

  // For menus and shortcuts.
  QList<QAction*> playback_actions() const { return actions_; }

 public slots:
  void go_to(double time);
  void step_frames(int frames);
  // To the next (1) or previous (-1) mark.
  void go_to_mark(int direction);
  void add_mark();
  void remove_mark();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QAction* add_action(ActionIcon icon, const QString& text, const QKeySequence& key, const QString& help);
  void make_actions();
  void make_layout();
  void refresh_run();
  void refresh_marks();
  void refresh_time();
  void refresh_buttons();
  void play(int direction);

  CaptureSession& session_;
  Playback playback_;
  QTimer marks_timer_;  // marks are found anew a few times a second while a run grows
  TimelineStrip* strip_;
  QLabel* time_;
  QComboBox* speed_;
  QAction *first_, *back_, *step_back_, *play_, *step_, *last_, *loop_;
  QList<QAction*> actions_;
};

}  // namespace netpocket
