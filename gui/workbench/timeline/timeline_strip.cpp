#include "gui/workbench/timeline/timeline_strip.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "gui/workbench/panels/focus_frame.h"

namespace netpocket {
namespace {

constexpr double kMargin = 12;      // pixels, left and right of the track
constexpr double kTrackTop = 18;    // pixels; marks stand above
constexpr double kTrackHeight = 8;  // pixels
constexpr double kCatchRadius = 5;  // pixels, of marks
constexpr double kEdge = 3;         // pixels, beside the first and the last number
constexpr double kShortestSpan = 1e-3;

// 1, 2 or 5 times a power of ten, at least `smallest`.
double tick_step(double smallest) {
  const double power = std::pow(10, std::floor(std::log10(smallest)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= smallest) return factor * power;
  }
  return 10 * power;
}

}  // namespace

QColor mark_color(TimeMark::Kind kind, const QPalette& palette) {
  const bool dark = palette.window().color().lightness() < 128;
  switch (kind) {
    case TimeMark::Kind::first_contact:
      return dark ? QColor(86, 180, 233) : QColor(0, 114, 178);
    case TimeMark::Kind::peak_force:
      return dark ? QColor(255, 140, 70) : QColor(213, 94, 0);
    case TimeMark::Kind::phase_end:
      return dark ? QColor(60, 200, 160) : QColor(0, 140, 105);
    case TimeMark::Kind::phase_start:
      return dark ? QColor(225, 150, 195) : QColor(180, 85, 140);
    case TimeMark::Kind::branch:
    case TimeMark::Kind::strategy:
    case TimeMark::Kind::disturbance:
      return dark ? QColor(240, 228, 66) : QColor(150, 120, 0);
    case TimeMark::Kind::own:
      break;
  }
  return palette.text().color();
}

TimelineStrip::TimelineStrip(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Timeline"));
  new FocusFrame(this);
}

QSize TimelineStrip::sizeHint() const {
  return {320, static_cast<int>(kTrackTop + kTrackHeight + 6) + fontMetrics().height()};
}

void TimelineStrip::set_extent(double recorded_end, double planned_end) {
  if (recorded_ == recorded_end && planned_ == planned_end) return;
  recorded_ = recorded_end;
  planned_ = planned_end;
  update();
}

void TimelineStrip::set_time(double time) {
  if (time_ == time) return;
  time_ = time;
  update();
}

void TimelineStrip::set_marks(std::vector<TimeMark> marks) {
  marks_ = std::move(marks);
  update();
}

double TimelineStrip::span() const { return std::max({recorded_, planned_, kShortestSpan}); }

QRectF TimelineStrip::track() const { return {kMargin, kTrackTop, width() - 2 * kMargin, kTrackHeight}; }

double TimelineStrip::x_at(double time) const { return track().left() + track().width() * time / span(); }

double TimelineStrip::time_at(double x) const {
  return std::clamp((x - track().left()) / track().width() * span(), 0.0, recorded_);
}

const TimeMark* TimelineStrip::mark_near(double x) const {
  const TimeMark* best = nullptr;
  for (const TimeMark& mark : marks_) {
    const double distance = std::abs(x_at(mark.time) - x);
    if (distance <= kCatchRadius && (!best || distance < std::abs(x_at(best->time) - x))) best = &mark;
  }
  return best;
}

void TimelineStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor groove = palette().text().color();
  groove.setAlpha(45);
  painter.setPen(Qt::NoPen);
  painter.setBrush(groove);
  painter.drawRoundedRect(track(), 4, 4);
  QRectF recorded = track();
  recorded.setRight(x_at(recorded_));
  QColor filled = palette().highlight().color();
  filled.setAlpha(isEnabled() ? 130 : 60);
  painter.setBrush(filled);
  painter.drawRoundedRect(recorded, 4, 4);
  paint_ticks(painter);
  paint_marks(painter);
  if (recorded_ > 0) paint_handle(painter);
}

void TimelineStrip::paint_ticks(QPainter& painter) const {
  if (span() <= kShortestSpan) return;
  const QFontMetrics metrics = fontMetrics();
  const double label_width = metrics.horizontalAdvance("000.00 s") + 18;
  const double step = tick_step(std::max(1e-4, span() * label_width / track().width()));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const int top = static_cast<int>(track().bottom()) + 4;
  for (int i = 0; i * step <= span() * (1 + 1e-9); ++i) {
    const QString label = QString("%1 s").arg(i * step, 0, 'g', 4);
    const int width = metrics.horizontalAdvance(label);
    const double x = std::clamp(x_at(i * step) - width / 2.0, kEdge, this->width() - width - kEdge);
    painter.drawText(QRectF(x, top, width + 1, metrics.height()), Qt::AlignCenter, label);
  }
}

void TimelineStrip::paint_marks(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  for (const TimeMark& mark : marks_) {
    if (mark.time > span()) continue;
    QColor color = mark_color(mark.kind, palette());
    // What is still to come is paler.
    if (mark.time > recorded_ + 1e-9) color.setAlpha(110);
    painter.setBrush(color);
    const double x = x_at(mark.time);
    if (mark.kind == TimeMark::Kind::own) {
      painter.drawPolygon(QPolygonF({{x, 3}, {x + 8, 7}, {x, 11}}));
    } else {
      painter.drawPolygon(QPolygonF({{x - 5, 4}, {x + 5, 4}, {x, 12}}));
    }
    painter.drawRect(QRectF(x - 0.75, 4, 1.5, kTrackTop + kTrackHeight - 4));
  }
}

void TimelineStrip::paint_handle(QPainter& painter) const {
  const double x = x_at(time_), middle = track().center().y();
  painter.setPen(QPen(hasFocus() ? palette().highlight().color() : palette().text().color(), 2));
  painter.setBrush(palette().base());
  painter.drawEllipse(QPointF(x, middle), 7, 7);
}

void TimelineStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || recorded_ <= 0) return;
  const TimeMark* mark = mark_near(event->position().x());
  emit time_chosen(mark && event->position().y() < kTrackTop ? std::min(mark->time, recorded_)
                                                             : time_at(event->position().x()));
}

void TimelineStrip::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton && recorded_ > 0) emit time_chosen(time_at(event->position().x()));
}

void TimelineStrip::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      emit step_requested(-1);
      return;
    case Qt::Key_Right:
      emit step_requested(1);
      return;
    case Qt::Key_PageUp:
      emit time_chosen(std::max(0.0, time_ - 1));
      return;
    case Qt::Key_PageDown:
      emit time_chosen(std::min(recorded_, time_ + 1));
      return;
    case Qt::Key_Home:
      emit time_chosen(0);
      return;
    case Qt::Key_End:
      emit time_chosen(recorded_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void TimelineStrip::focusInEvent(QFocusEvent*) { update(); }
void TimelineStrip::focusOutEvent(QFocusEvent*) { update(); }

bool TimelineStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const TimeMark* mark = mark_near(help->pos().x());
  const QString text = mark ? QString("%1\n%2 s").arg(mark->label).arg(mark->time, 0, 'f', 3)
                            : tr("%1 s – click or drag to go there").arg(time_at(help->pos().x()), 0, 'f', 2);
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

}  // namespace netpocket
