#pragma once
// The desktop's style, made readable on dark grounds: boxes to tick get frames that can be seen (Qt's Fusion draws them
// in nearly the ground's colour), dialogs' buttons get no icons, which are black there. Notes and hints, which desktops
// often make too pale, are as readable as other texts. A button that has the keys looks different from the default one.

#include <QProxyStyle>

namespace netpocket {

class WindowStyle : public QProxyStyle {
  Q_OBJECT
 public:
  // `key`: the name of a style, or empty for the desktop's own.
  explicit WindowStyle(const QString& key = {});

  QPalette standardPalette() const override;
  using QProxyStyle::polish;
  void polish(QPalette& palette) override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* answer) const override;
};

}  // namespace netpocket
