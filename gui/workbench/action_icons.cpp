#include "gui/workbench/action_icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace netpocket {
namespace {

// All shapes live in a square of 16 units.
constexpr double kUnits = 16;

QPolygonF triangle(double tip, double base) { return QPolygonF({{tip, 8}, {base, 3}, {base, 13}}); }

void draw_arc_arrow(QPainter& painter, int start, int length) {
  painter.setBrush(Qt::NoBrush);
  painter.drawArc(QRectF(3, 3, 10, 10), start * 16, length * 16);
}

class Drawing {
 public:
  Drawing(QPainter& painter, const QColor& color) : painter_(painter), color_(color) {
    painter_.setPen(QPen(color_, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(color_);
  }

  void draw(ActionIcon icon) {
    switch (icon) {
      case ActionIcon::run:
      case ActionIcon::play:
        return fill(triangle(13, 4));
      case ActionIcon::play_back:
        return fill(triangle(3, 12));
      case ActionIcon::pause:
        return bars({4, 9.5}, 2.5);
      case ActionIcon::step:
        bars({2.5}, 2);
        return fill(triangle(14, 6.5));
      case ActionIcon::next_frame:
        bars({11}, 2);
        return fill(triangle(10, 3));
      case ActionIcon::previous_frame:
        bars({3}, 2);
        return fill(triangle(6, 13));
      case ActionIcon::first:
        bars({2}, 1.6);
        fill(triangle(4, 9));
        return fill(triangle(9, 14));
      case ActionIcon::last:
        bars({12.4}, 1.6);
        fill(triangle(12, 7));
        return fill(triangle(7, 2));
      case ActionIcon::restart:
        draw_arc_arrow(painter_, 110, 300);
        return fill(QPolygonF({{3.2, 1.2}, {8.2, 2.9}, {4.4, 6.4}}));
      case ActionIcon::loop:
        return loop();
      case ActionIcon::branch:
        return branch();
      case ActionIcon::mark:
        painter_.drawLine(QPointF(4, 2.5), QPointF(4, 14));
        return fill(QPolygonF({{4, 2.5}, {13, 5.5}, {4, 8.5}}));
      case ActionIcon::fit:
        return fit();
      case ActionIcon::measure:
        return measure();
      case ActionIcon::follow:
        return follow();
      case ActionIcon::move:
        return move();
      case ActionIcon::split:
        painter_.setBrush(Qt::NoBrush);
        painter_.drawRoundedRect(QRectF(2, 3, 12, 10), 1.2, 1.2);
        painter_.drawLine(QPointF(8, 3), QPointF(8, 13));
        return;
      case ActionIcon::open:
        painter_.setBrush(Qt::NoBrush);
        painter_.drawPolyline(QPolygonF({{2, 13}, {2, 3.5}, {6, 3.5}, {7.5, 5.5}, {12.5, 5.5}, {12.5, 7.5}}));
        painter_.drawPolygon(QPolygonF({{2, 13}, {4.5, 7.5}, {14.5, 7.5}, {12.5, 13}}));
        return;
      case ActionIcon::save:
        painter_.setBrush(Qt::NoBrush);
        painter_.drawPolygon(QPolygonF({{2.5, 2.5}, {11.5, 2.5}, {13.5, 4.5}, {13.5, 13.5}, {2.5, 13.5}}));
        painter_.drawRect(QRectF(5, 9, 6, 4.5));
        painter_.drawLine(QPointF(5.5, 2.5), QPointF(5.5, 5.5));
        painter_.drawLine(QPointF(5.5, 5.5), QPointF(10, 5.5));
        return;
    }
  }

 private:
  void fill(const QPolygonF& polygon) {
    painter_.setPen(QPen(color_, 1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(color_);
    painter_.drawPolygon(polygon);
  }

  void bars(std::initializer_list<double> lefts, double width) {
    painter_.setPen(Qt::NoPen);
    for (const double left : lefts) painter_.drawRoundedRect(QRectF(left, 3, width, 10), 0.8, 0.8);
  }

  void loop() {
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(QPolygonF({{4, 11.5}, {2.5, 11.5}, {2.5, 4.5}, {11, 4.5}}));
    painter_.drawPolyline(QPolygonF({{12, 4.5}, {13.5, 4.5}, {13.5, 11.5}, {5, 11.5}}));
    fill(QPolygonF({{9, 2}, {12, 4.5}, {9, 7}}));
    fill(QPolygonF({{7, 9}, {4, 11.5}, {7, 14}}));
  }

  void branch() {
    painter_.setBrush(Qt::NoBrush);
    painter_.drawLine(QPointF(2, 11), QPointF(14, 11));
    QPainterPath path(QPointF(4, 11));
    path.cubicTo(QPointF(8, 11), QPointF(7, 4.5), QPointF(11, 4.5));
    painter_.drawPath(path);
    painter_.setBrush(color_);
    painter_.drawEllipse(QPointF(12, 4.5), 1.6, 1.6);
  }

  void fit() {
    painter_.setBrush(Qt::NoBrush);
    for (const auto& [x, y] :
         {std::pair(2.5, 2.5), std::pair(13.5, 2.5), std::pair(2.5, 13.5), std::pair(13.5, 13.5)}) {
      const double dx = x < 8 ? 3.5 : -3.5, dy = y < 8 ? 3.5 : -3.5;
      painter_.drawPolyline(QPolygonF({{x + dx, y}, {x, y}, {x, y + dy}}));
    }
    painter_.drawEllipse(QPointF(8, 8), 2.2, 2.2);
  }

  void measure() {
    painter_.drawLine(QPointF(3, 13), QPointF(13, 3));
    for (const double at : {3.0, 13.0}) painter_.drawEllipse(QPointF(at, 16 - at), 1.4, 1.4);
  }

  void follow() {
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(QPointF(8, 8), 4.2, 4.2);
    painter_.drawLine(QPointF(8, 1.5), QPointF(8, 5.5));
    painter_.drawLine(QPointF(8, 10.5), QPointF(8, 14.5));
    painter_.drawLine(QPointF(1.5, 8), QPointF(5.5, 8));
    painter_.drawLine(QPointF(10.5, 8), QPointF(14.5, 8));
  }

  void move() {
    painter_.drawLine(QPointF(8, 3), QPointF(8, 13));
    painter_.drawLine(QPointF(3, 8), QPointF(13, 8));
    fill(QPolygonF({{8, 1.2}, {6, 4}, {10, 4}}));
    fill(QPolygonF({{8, 14.8}, {6, 12}, {10, 12}}));
    fill(QPolygonF({{1.2, 8}, {4, 6}, {4, 10}}));
    fill(QPolygonF({{14.8, 8}, {12, 6}, {12, 10}}));
  }

  QPainter& painter_;
  QColor color_;
};

class ActionIconEngine final : public QIconEngine {
 public:
  explicit ActionIconEngine(ActionIcon icon) : icon_(icon) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / kUnits, rect.height() / kUnits);
    Drawing(*painter, QGuiApplication::palette().color(group, QPalette::ButtonText)).draw(icon_);
    painter->restore();
  }

  // Drawn each time, so that a change between light and dark shows at once.
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new ActionIconEngine(icon_); }

 private:
  ActionIcon icon_;
};

}  // namespace

QIcon action_icon(ActionIcon icon) { return QIcon(new ActionIconEngine(icon)); }

}  // namespace netpocket
