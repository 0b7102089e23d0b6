#pragma once
// The strip of time below the viewport: what is recorded, where one is, and the moments worth going to.
//
// Drag or click: goes there; near a mark, exactly to it. Keys, with the strip in focus: left and right a frame, Page Up
// and Down a second, Home and End.

#include <QWidget>
#include <vector>

#include "gui/workbench/session/run.h"

namespace netpocket {

class TimelineStrip : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineStrip(QWidget* parent = nullptr);

  // s: what is recorded so far and where the run will end.
  void set_extent(double recorded_end, double planned_end);
  void set_time(double time);
  void set_marks(std::vector<TimeMark> marks);
  double time() const { return time_; }
  const std::vector<TimeMark>& marks() const { return marks_; }

  // The x coordinate of a time, pixels.
  double x_at(double time) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

 signals:
  void time_chosen(double time);
  void step_requested(int frames);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  double span() const;
  double time_at(double x) const;
  const TimeMark* mark_near(double x) const;
  QRectF track() const;
  void paint_ticks(QPainter& painter) const;
  void paint_marks(QPainter& painter) const;
  void paint_handle(QPainter& painter) const;

  double recorded_ = 0;
  double planned_ = 0;
  double time_ = 0;
  std::vector<TimeMark> marks_;
};

// The colour of a kind of mark, readable on the palette's window.
QColor mark_color(TimeMark::Kind kind, const QPalette& palette);

}  // namespace netpocket
