#pragma once
// A frame in a widget that paints itself, shown while keys act on it and it was gone to by key: who clicks knows it.
// Thread contract: the user interface's thread.

#include <QWidget>

namespace netpocket {

class FocusFrame : public QWidget {
  Q_OBJECT
 public:
  // The frame is a child of the widget, over its other children.
  explicit FocusFrame(QWidget* widget);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace netpocket
