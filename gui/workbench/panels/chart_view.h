#pragma once
// A figure of curves over time on the screen, with a cursor, zoom and pan in time.
//
// Wheel: zoom about the mouse. Drag: pan; drag of the cursor: moves the time. Click: goes there. Double click, Home or
// 0: everything. Plus, minus, left, right: zoom and pan.

#include <QWidget>
#include <optional>

#include "gui/workbench/panels/figure_image.h"
#include "gui/workbench/panels/time_window.h"

namespace netpocket {

class ChartView : public QWidget {
  Q_OBJECT
 public:
  explicit ChartView(QWidget* parent = nullptr);

  // The figure's title is not drawn, all panels show the same stretch of time, and the columns give way to the size of
  // the widget.
  void set_figure(Figure figure);
  const Figure& figure() const { return figure_; }

  // Pixels that a panel should have; where there are fewer, panels stand below each other, unless they would become too
  // flat to read.
  void set_panel_width(int width);

  // Shown instead of a figure without data.
  void set_placeholder(const QString& text);

  // Line at a time, s; none when empty.
  void set_cursor(std::optional<double> time);
  std::optional<double> cursor_time() const { return cursor_; }

  // The stretch of time shown; empty: everything, also what is still to come of a growing run.
  void set_window(std::optional<TimeRange> window);
  std::optional<TimeRange> window() const { return window_; }

  // The time under the mouse, if any.
  std::optional<double> probe_time() const { return probe_; }

  // Zooms about the middle of what is shown; factors below 1 show less time.
  void zoom(double factor);

  // The figure as shown: cut to the window, in as many columns as there is room for.
  Figure shown_figure() const;

  // The time under a point of the widget, if it is in the frame of a panel.
  std::optional<double> time_at(const QPointF& point) const;
  // Where a time stands in the first panel, halfway up.
  std::optional<QPointF> point_at(double time) const;

  QSize sizeHint() const override { return {520, 300}; }
  QSize minimumSizeHint() const override { return {220, 240}; }

 signals:
  void time_clicked(double time);  // also while the cursor is dragged
  void window_changed();
  void probed();  // probe_time() has changed

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Drag { none, pressed, pan, cursor };

  std::optional<TimeRange> shown_range() const;
  int fitting_columns() const;
  const PanelFrame* frame_at(const QPointF& point) const;
  void zoom_about(double time, double factor);
  void pan(double seconds);
  void set_probe(std::optional<double> time);
  void redraw();
  void draw_line(QPainter& painter, double time, const QPen& pen) const;
  void draw_placeholder(QPainter& painter) const;
  bool near_cursor(const QPointF& point) const;

  Figure figure_;
  QString placeholder_;
  int panel_width_ = 250;
  std::optional<double> cursor_;
  std::optional<double> probe_;
  std::optional<TimeRange> window_;
  FigureImage drawn_;
  bool stale_ = true;
  Drag drag_ = Drag::none;
  QPointF pressed_at_;
  TimeRange pressed_range_;
  double pressed_scale_ = 0;  // s per pixel
};

}  // namespace netpocket
