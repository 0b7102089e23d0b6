#include "gui/workbench/filming/window_picture.h"

#include <QApplication>
#include <QBackingStore>
#include <QCursor>
#include <QOpenGLWidget>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

QImage blank_image(const QWidget& window) {
  const double ratio = window.devicePixelRatioF();
  const auto pixels = [ratio](int length) { return static_cast<int>(std::lround(length * ratio)); };
  QImage image(pixels(window.width()), pixels(window.height()), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(window.palette().color(QPalette::Window));
  return image;
}

// What the platform keeps of the window to show it again; null where it keeps nothing that can be read.
const QImage* kept_image(const QWidget& window, const QSize& pixels) {
  const QString platform = QGuiApplication::platformName();
  if (platform != "xcb" && platform != "offscreen") return nullptr;
  auto* store = window.backingStore();
  auto* device = store != nullptr ? store->paintDevice() : nullptr;
  if (device == nullptr || device->devType() != QInternal::Image) return nullptr;
  const auto* image = static_cast<const QImage*>(device);
  return image->size() == pixels ? image : nullptr;
}

// Views drawn with OpenGL lie behind the window, which has holes there.
void draw_opengl_views(QPainter& painter, const QWidget& window) {
  for (auto* view : window.findChildren<QOpenGLWidget*>()) {
    if (view->isVisible()) {
      painter.drawImage(QRect(view->mapTo(&window, QPoint()), view->size()), view->grabFramebuffer());
    }
  }
}

bool draw_kept(QPainter& painter, const QWidget& window, const QSize& pixels) {
  const QImage* kept = kept_image(window, pixels);
  if (kept == nullptr) return false;
  draw_opengl_views(painter, window);
  painter.drawImage(window.rect(), *kept);
  return true;
}

// The higher, the nearer to the eye.
int height_of(const QWidget& widget) {
  switch (widget.windowType()) {
    case Qt::ToolTip:
      return 2;
    case Qt::Popup:
      return 1;
    default:
      return 0;
  }
}

QWidgetList windows_over(const QWidget& window) {
  QWidgetList found;
  for (QWidget* other : QApplication::topLevelWidgets()) {
    const bool shown = other != &window && other->isVisible() && !other->isMinimized();
    if (shown && other->frameGeometry().intersects(window.frameGeometry())) found << other;
  }
  std::ranges::stable_sort(found, {}, [](const QWidget* widget) { return height_of(*widget); });
  return found;
}

void draw_windows_over(QPainter& painter, const QWidget& window) {
  for (QWidget* other : windows_over(window)) {
    const QRect place(window.mapFromGlobal(other->mapToGlobal(QPoint())), other->size());
    painter.drawPixmap(place, other->grab());
    painter.setPen(other->palette().color(QPalette::Mid));
    if (height_of(*other) == 0) painter.drawRect(place.adjusted(-1, -1, 0, 0));
  }
}

void draw_pointer(QPainter& painter, const QWidget& window) {
  const QPointF tip = window.mapFromGlobal(QCursor::pos());
  if (!window.rect().contains(tip.toPoint())) return;
  const QPolygonF arrow({{0, 0}, {0, 16}, {3.8, 12.6}, {6.2, 18}, {8.6, 17}, {6.2, 11.8}, {11.2, 11.8}});
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::white, 1.2));
  painter.setBrush(Qt::black);
  painter.drawPolygon(arrow.translated(tip));
}

}  // namespace

QImage window_picture(QWidget& window) {
  QImage image = blank_image(window);
  QPainter painter(&image);
  window.render(&painter);
  draw_windows_over(painter, window);
  return image;
}

QImage window_frame(QWidget& window) {
  QImage image = blank_image(window);
  QPainter painter(&image);
  if (!draw_kept(painter, window, image.size())) window.render(&painter);
  draw_windows_over(painter, window);
  draw_pointer(painter, window);
  return image;
}

}  // namespace netpocket
