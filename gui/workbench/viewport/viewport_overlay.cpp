#include "gui/workbench/viewport/viewport_overlay.h"

#include <QPainter>
#include <algorithm>

namespace netpocket {
namespace {

const QColor kMark(213, 94, 0);  // vermilion: seen on white, on space and on every colour map

}  // namespace

ViewportOverlay::ViewportOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void ViewportOverlay::set_camera(const CameraView& view) {
  camera_ = OrbitCamera(view);
  update();
}

void ViewportOverlay::set_selection(const std::optional<Eigen::Vector3d>& point) {
  selection_ = point;
  update();
}

void ViewportOverlay::set_measure(const std::vector<Eigen::Vector3d>& points) {
  measure_ = points;
  update();
}

void ViewportOverlay::set_message(const QString& message) {
  if (message == message_) return;
  message_ = message;
  update();
}

void ViewportOverlay::set_hint(const QString& hint) {
  if (hint == hint_) return;
  hint_ = hint;
  update();
}

void ViewportOverlay::set_dark(bool dark) {
  dark_ = dark;
  update();
}

void ViewportOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_selection(painter);
  paint_measure(painter);
  if (!hint_.isEmpty()) paint_hint(painter);
  if (message_.isEmpty()) return;
  painter.setPen(dark_ ? QColor(190, 196, 206) : QColor(90, 95, 104));
  QFont font = painter.font();
  font.setPointSizeF(1.2 * font.pointSizeF());
  painter.setFont(font);
  painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, message_);
}

// In the middle, but in a narrow view right of the time, which stands at the left.
void ViewportOverlay::paint_hint(QPainter& painter) const {
  constexpr double kTimeWidth = 120, kMargin = 12;
  const double half = painter.fontMetrics().horizontalAdvance(hint_) / 2.0 + kMargin;
  const double right_of_time = std::min(kTimeWidth + half, width() - half);
  paint_label(painter, QPointF(std::max(width() / 2.0, right_of_time), 24), hint_);
}

void ViewportOverlay::paint_selection(QPainter& painter) const {
  if (!selection_) return;
  const auto point = camera_.project(*selection_, size());
  if (!point) return;
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, width] : {std::pair(QColor(255, 255, 255, 200), 4.0), std::pair(kMark, 2.0)}) {
    painter.setPen(QPen(color, width));
    painter.drawEllipse(point->position, 7, 7);
  }
}

void ViewportOverlay::paint_measure(QPainter& painter) const {
  std::vector<QPointF> ends;
  for (const Eigen::Vector3d& point : measure_) {
    const auto end = camera_.project(point, size());
    if (!end) return;
    ends.push_back(end->position);
  }
  if (ends.size() == 2) {
    painter.setPen(QPen(QColor(255, 255, 255, 200), 4));
    painter.drawLine(ends[0], ends[1]);
    painter.setPen(QPen(kMark, 2, Qt::DashLine));
    painter.drawLine(ends[0], ends[1]);
  }
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(kMark);
  for (const QPointF& end : ends) painter.drawEllipse(end, 4.5, 4.5);
  if (ends.size() < 2) return;
  const double distance = (measure_[1] - measure_[0]).norm();
  paint_label(painter, (ends[0] + ends[1]) / 2 + QPointF(0, -18), QString("%1 m").arg(distance, 0, 'f', 3));
}

void ViewportOverlay::paint_label(QPainter& painter, const QPointF& center, const QString& text) const {
  const QRectF box = painter.fontMetrics().boundingRect(text).adjusted(-8, -4, 8, 4);
  const QRectF placed(center - QPointF(box.width() / 2, box.height() / 2), box.size());
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(30, 34, 40, 225));
  painter.drawRoundedRect(placed, 4, 4);
  painter.setPen(Qt::white);
  painter.drawText(placed, Qt::AlignCenter, text);
}

}  // namespace netpocket
