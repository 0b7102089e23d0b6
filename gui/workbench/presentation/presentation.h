#pragma once
// What one shows to an audience: the whole screen for the view, the timeline and the numbers of the moment, in large
// type. Afterwards the window is as it was before.
// Thread contract: the user interface's thread.

#include <QMainWindow>
#include <QObject>
#include <QPointer>

class QAction;
class QMenu;

namespace netpocket {

class Presentation : public QObject {
  Q_OBJECT
 public:
  static constexpr double kTypeScale = 1.6;  // on a small screen; larger ones get larger letters

  // `headline` is shown meanwhile; `focus` is what keys act on then. Both are in the window's central widget.
  Presentation(QMainWindow& window, QWidget& headline, QWidget& focus);

  void fill(QMenu& menu);
  bool is_on() const { return on_; }
  void set_on(bool on);

 signals:
  // `scale`: of the letters against those of the window.
  void changed(bool on, double scale);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Before {
    QRect geometry;
    Qt::WindowStates state;
    QByteArray layout;
    bool status_bar = true;
    QPointer<QWidget> focus;
  };

  void enter();
  void leave();
  double scale() const;

  QMainWindow& window_;
  QWidget& headline_;
  QWidget& focus_;
  QAction* action_ = nullptr;
  QAction* escape_;
  Before before_;
  bool on_ = false;
  bool returning_ = false;  // the window has not got its size back yet
};

}  // namespace netpocket
