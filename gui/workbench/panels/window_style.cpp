#include "gui/workbench/panels/window_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "gui/workbench/panels/tones.h"

namespace netpocket {

// A proxy without a style of its own stands for the desktop's.
WindowStyle::WindowStyle(const QString& key) : QProxyStyle(key.isEmpty() ? nullptr : QStyleFactory::create(key)) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  const bool box = element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
  if (!box || !is_dark(option->palette)) return;
  QColor frame = option->palette.color(QPalette::Text);
  frame.setAlphaF(0.5);
  painter->save();
  painter->setPen(frame);
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  painter->restore();
}

int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* answer) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, answer);
}

}  // namespace netpocket
