#include "gui/workbench/panels/icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPixmapCache>
#include <QPolygonF>

namespace netpocket {
namespace {

constexpr int kSize = 16;

// An open circle from `start` degrees over `span`, with an arrow head at its end.
void draw_turning_arrow(QPainter& painter, double start, double span) {
  const QRectF circle(3, 3, 10, 10);
  QPainterPath arc;
  arc.arcMoveTo(circle, start);
  arc.arcTo(circle, start, span);
  painter.drawPath(arc);
  painter.save();
  painter.translate(arc.currentPosition());
  const double heading = span > 0 ? -(start + span) - 90 : -(start + span) + 90;
  painter.rotate(heading);
  painter.setBrush(painter.pen().color());
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(QPolygonF({{-1.2, -3}, {3, 0}, {-1.2, 3}}));
  painter.restore();
}

void draw(Glyph glyph, QPainter& painter) {
  switch (glyph) {
    case Glyph::reset:
      draw_turning_arrow(painter, -60, 240);
      break;
    case Glyph::restart:
      draw_turning_arrow(painter, 70, -300);
      break;
    case Glyph::at_once:
      painter.setBrush(painter.pen().color());
      painter.setPen(Qt::NoPen);
      painter.drawPolygon(QPolygonF({{9.5, 1}, {3.5, 9}, {7.5, 9}, {6, 15}, {12.5, 6.5}, {8.3, 6.5}}));
      break;
    case Glyph::yes:
      painter.drawPolyline(QPolygonF({{3, 8.5}, {6.5, 12}, {13, 4}}));
      break;
    case Glyph::no:
      painter.drawLine(QPointF(4, 4), QPointF(12, 12));
      painter.drawLine(QPointF(12, 4), QPointF(4, 12));
      break;
    case Glyph::pending:
      painter.drawEllipse(QRectF(2.5, 2.5, 11, 11));
      painter.drawPolyline(QPolygonF({{8, 5}, {8, 8}, {10.3, 9.3}}));
      break;
    case Glyph::add:
      painter.drawLine(QPointF(8, 3.5), QPointF(8, 12.5));
      [[fallthrough]];
    case Glyph::remove:
      painter.drawLine(QPointF(3.5, 8), QPointF(12.5, 8));
      break;
  }
}

// A form shows a hundred of a few glyphs: each is drawn once.
QPixmap pixmap(Glyph glyph, const QColor& colour, double ratio) {
  const QString key = QString("netpocket/%1/%2/%3").arg(static_cast<int>(glyph)).arg(colour.name()).arg(ratio);
  QPixmap result;
  if (QPixmapCache::find(key, &result)) return result;
  result = QPixmap(QSize(kSize, kSize) * ratio);
  result.setDevicePixelRatio(ratio);
  result.fill(Qt::transparent);
  QPainter painter(&result);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  draw(glyph, painter);
  painter.end();
  QPixmapCache::insert(key, result);
  return result;
}

}  // namespace

QIcon glyph_icon(Glyph glyph, Tone tone, const QPalette& palette) {
  QIcon icon;
  for (const double ratio : {1.0, 2.0, 3.0}) icon.addPixmap(pixmap(glyph, tone_colour(tone, palette), ratio));
  return icon;
}

}  // namespace netpocket
