#include "gui/workbench/panels/chart_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/workbench/panels/focus_frame.h"
#include "gui/workbench/panels/tones.h"
#include "gui/workbench/panels/window_look.h"

namespace netpocket {
namespace {

constexpr int kGrip = 4;                  // pixels from the cursor at which a drag takes it along
constexpr double kWheelStep = 1.2;        // zoom by a notch of the wheel
constexpr double kNotch = 120;            // wheel units
constexpr double kShortestWindow = 1e-4;  // of all time
constexpr double kKeyPan = 0.1;           // of the window
constexpr int kFlatRow = 105;             // pixels, lower rows are hard to read
constexpr int kNarrowPanel = 135;         // pixels, narrower panels are hard to read

}  // namespace

ChartView::ChartView(QWidget* parent) : QWidget(parent), placeholder_(tr("No data")) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("Chart"));
  new FocusFrame(this);
}

void ChartView::set_figure(Figure figure) {
  figure_ = std::move(figure);
  figure_.title.clear();
  redraw();
}

void ChartView::set_panel_width(int width) {
  panel_width_ = width;
  redraw();
}

void ChartView::set_placeholder(const QString& text) {
  placeholder_ = text;
  update();
}

void ChartView::set_cursor(std::optional<double> time) {
  if (time == cursor_) return;
  cursor_ = time;
  update();
}

void ChartView::set_window(std::optional<TimeRange> window) {
  const auto all = time_range(figure_);
  if (window && all) {
    const double length = std::clamp(window->length(), kShortestWindow * all->length(), all->length());
    const double begin = std::clamp(window->begin, all->begin, all->end - length);
    window = TimeRange{begin, begin + length};
    if (length >= all->length()) window.reset();
  }
  if (window == window_) return;
  window_ = window;
  redraw();
  emit window_changed();
}

void ChartView::zoom(double factor) {
  if (const auto range = shown_range()) zoom_about((range->begin + range->end) / 2, factor);
}

Figure ChartView::shown_figure() const {
  Figure shown = window_ ? cut(figure_, *window_) : figure_;
  if (const auto range = shown_range()) share_time(shown, *range);
  shown.columns = fitting_columns();
  return shown;
}

int ChartView::fitting_columns() const {
  const int wanted = std::max(figure_.columns, 1), count = static_cast<int>(figure_.panels.size());
  // Larger letters need more room.
  const int across = static_cast<int>(width() / type_scale()), down = static_cast<int>(height() / type_scale());
  int columns = std::clamp(across / panel_width_, 1, wanted);
  const auto row_height = [&] { return down / std::max(1, (count + columns - 1) / columns); };
  while (columns < wanted && row_height() < kFlatRow && across / (columns + 1) >= kNarrowPanel) ++columns;
  return columns;
}

std::optional<TimeRange> ChartView::shown_range() const { return window_ ? window_ : time_range(figure_); }

const PanelFrame* ChartView::frame_at(const QPointF& point) const {
  for (const PanelFrame& panel : drawn_.panels) {
    if (QRectF(panel.box.x, panel.box.y, panel.box.width, panel.box.height).contains(point)) return &panel;
  }
  return nullptr;
}

std::optional<double> ChartView::time_at(const QPointF& point) const {
  const PanelFrame* frame = frame_at(point);
  if (!frame || !time_range(figure_)) return std::nullopt;
  return frame->x.low + (point.x() - frame->box.x) / frame->box.width * frame->x.span();
}

std::optional<QPointF> ChartView::point_at(double time) const {
  if (drawn_.panels.empty() || !time_range(figure_)) return std::nullopt;
  const PanelFrame& frame = drawn_.panels.front();
  const double part = (time - frame.x.low) / frame.x.span();
  if (!(part >= 0 && part <= 1)) return std::nullopt;
  return QPointF(frame.box.x + part * frame.box.width, frame.box.y + frame.box.height / 2);
}

void ChartView::zoom_about(double time, double factor) {
  const auto range = shown_range();
  if (!range) return;
  set_window(TimeRange{time + (range->begin - time) * factor, time + (range->end - time) * factor});
}

void ChartView::pan(double seconds) {
  if (window_) set_window(TimeRange{window_->begin + seconds, window_->end + seconds});
}

void ChartView::redraw() {
  stale_ = true;
  update();
}

void ChartView::set_probe(std::optional<double> time) {
  if (time == probe_) return;
  probe_ = time;
  update();
  emit probed();
}

bool ChartView::near_cursor(const QPointF& point) const {
  const PanelFrame* frame = frame_at(point);
  if (!cursor_ || !frame) return false;
  const double x = frame->box.x + (*cursor_ - frame->x.low) / frame->x.span() * frame->box.width;
  return std::abs(point.x() - x) <= kGrip;
}

// ---- painting ----

void ChartView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!time_range(figure_)) {
    draw_placeholder(painter);
    return;
  }
  if (stale_) {
    drawn_ = figure_image(shown_figure(), size(), devicePixelRatioF(), palette(), type_scale());
    stale_ = false;
  }
  painter.drawImage(QPoint(0, 0), drawn_.image);
  if (probe_) draw_line(painter, *probe_, QPen(tone_colour(Tone::muted, palette()), 1, Qt::DotLine));
  if (cursor_) draw_line(painter, *cursor_, QPen(tone_colour(Tone::accent, palette()), 2));
}

void ChartView::draw_line(QPainter& painter, double time, const QPen& pen) const {
  painter.setPen(pen);
  for (const PanelFrame& panel : drawn_.panels) {
    const double part = (time - panel.x.low) / panel.x.span();
    if (!(part >= 0 && part <= 1)) continue;
    const double x = std::round(panel.box.x + part * panel.box.width);  // sharp
    painter.drawLine(QPointF(x, panel.box.y), QPointF(x, panel.box.bottom()));
  }
}

void ChartView::draw_placeholder(QPainter& painter) const {
  painter.fillRect(rect(), palette().base());
  painter.setPen(tone_colour(Tone::muted, palette()));
  painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, placeholder_);
}

void ChartView::resizeEvent(QResizeEvent*) { redraw(); }

void ChartView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) redraw();
  QWidget::changeEvent(event);
}

// ---- mouse and keyboard ----

void ChartView::wheelEvent(QWheelEvent* event) {
  const auto time = time_at(event->position());
  if (!time || event->angleDelta().y() == 0) {
    event->ignore();
    return;
  }
  zoom_about(*time, std::pow(kWheelStep, -event->angleDelta().y() / kNotch));
  event->accept();
}

void ChartView::mousePressEvent(QMouseEvent* event) {
  const PanelFrame* frame = frame_at(event->position());
  const auto range = shown_range();
  if (event->button() != Qt::LeftButton || !frame || !range) return;
  drag_ = near_cursor(event->position()) ? Drag::cursor : Drag::pressed;
  pressed_at_ = event->position();
  pressed_range_ = *range;
  pressed_scale_ = frame->x.span() / frame->box.width;
}

void ChartView::mouseMoveEvent(QMouseEvent* event) {
  const double way = event->position().x() - pressed_at_.x();
  if (drag_ == Drag::pressed && std::abs(way) >= QApplication::startDragDistance()) drag_ = Drag::pan;
  if (drag_ == Drag::pan) {
    const double shift = -way * pressed_scale_;
    if (window_) set_window(TimeRange{pressed_range_.begin + shift, pressed_range_.end + shift});
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  const auto time = time_at(event->position());
  if (drag_ == Drag::cursor && time) emit time_clicked(*time);
  const bool grips = drag_ == Drag::cursor || near_cursor(event->position());
  if (grips) {
    setCursor(Qt::SplitHCursor);
  } else {
    unsetCursor();
  }
  set_probe(time);
}

void ChartView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const Drag drag = std::exchange(drag_, Drag::none);
  unsetCursor();
  const auto time = time_at(event->position());
  if (time && (drag == Drag::pressed || drag == Drag::cursor)) emit time_clicked(*time);
}

void ChartView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) set_window(std::nullopt);
}

void ChartView::leaveEvent(QEvent*) { set_probe(std::nullopt); }

void ChartView::keyPressEvent(QKeyEvent* event) {
  const auto range = shown_range();
  const double length = range ? range->length() : 0;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(1 / kWheelStep);
    case Qt::Key_Minus:
      return zoom(kWheelStep);
    case Qt::Key_Left:
      return pan(-kKeyPan * length);
    case Qt::Key_Right:
      return pan(kKeyPan * length);
    case Qt::Key_Home:
    case Qt::Key_0:
      return set_window(std::nullopt);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace netpocket
