#pragma once
// The desktop's style, with boxes to tick whose frames can be seen on dark grounds: Qt's Fusion draws them in nearly
// the ground's colour.

#include <QProxyStyle>

namespace netpocket {

class WindowStyle : public QProxyStyle {
  Q_OBJECT
 public:
  // `key`: the name of a style, or empty for the desktop's own.
  explicit WindowStyle(const QString& key = {});

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace netpocket
