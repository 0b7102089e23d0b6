#include "gui/workbench/panels/window_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "gui/workbench/panels/tones.h"

namespace netpocket {

namespace {

void make_hints_readable(QPalette& palette) {
  palette.setColor(QPalette::Active, QPalette::PlaceholderText, tone_colour(Tone::muted, palette));
  palette.setColor(QPalette::Inactive, QPalette::PlaceholderText, tone_colour(Tone::muted, palette));
}

}  // namespace

// A proxy without a style of its own stands for the desktop's.
WindowStyle::WindowStyle(const QString& key) : QProxyStyle(key.isEmpty() ? nullptr : QStyleFactory::create(key)) {}

QPalette WindowStyle::standardPalette() const {
  QPalette palette = QProxyStyle::standardPalette();
  make_hints_readable(palette);
  return palette;
}

void WindowStyle::polish(QPalette& palette) {
  QProxyStyle::polish(palette);
  make_hints_readable(palette);
}

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

void WindowStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  QProxyStyle::drawControl(element, option, painter, widget);
  constexpr State kGoneToByKey = State_HasFocus | State_KeyboardFocusChange;
  if (element != CE_PushButton || (option->state & kGoneToByKey) != kGoneToByKey) return;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(tone_colour(Tone::accent, option->palette), 1.5));
  painter->setBrush(Qt::NoBrush);
  painter->drawRoundedRect(QRectF(option->rect).adjusted(3.5, 3.5, -3.5, -3.5), 2, 2);
  painter->restore();
}

int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* answer) const {
  if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
  return QProxyStyle::styleHint(hint, option, widget, answer);
}

}  // namespace netpocket
