#include "gui/workbench/panels/focus_frame.h"

#include <QFocusEvent>
#include <QPainter>

#include "gui/workbench/panels/tones.h"

namespace netpocket {
namespace {

bool came_by_key(const QEvent& event) {
  const auto reason = static_cast<const QFocusEvent&>(event).reason();
  return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
}

}  // namespace

FocusFrame::FocusFrame(QWidget* widget) : QWidget(widget) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  widget->installEventFilter(this);
  hide();
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) hide();
  const bool appears = event->type() == QEvent::FocusIn && came_by_key(*event);
  if (appears || event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  if (appears) {
    raise();
    show();
  }
  return QWidget::eventFilter(watched, event);
}

void FocusFrame::paintEvent(QPaintEvent*) {
  constexpr double kWidth = 2;  // pixels
  QPainter painter(this);
  painter.setPen(QPen(tone_colour(Tone::accent, palette()), kWidth));
  painter.drawRect(QRectF(rect()).adjusted(kWidth / 2, kWidth / 2, -kWidth / 2, -kWidth / 2));
}

}  // namespace netpocket
