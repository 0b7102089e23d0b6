#include "gui/workbench/presentation/presentation.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>

namespace netpocket {
namespace {

constexpr double kPlainHeight = 900;  // pixels of a screen on which letters need no more than kTypeScale

}  // namespace

Presentation::Presentation(QMainWindow& window, QWidget& headline, QWidget& focus)
    : QObject(&window), window_(window), headline_(headline), focus_(focus), escape_(new QAction(&window)) {
  escape_->setShortcut(Qt::Key_Escape);
  escape_->setEnabled(false);
  connect(escape_, &QAction::triggered, this, [this] { set_on(false); });
  window_.addAction(escape_);
  window_.installEventFilter(this);
}

void Presentation::fill(QMenu& menu) {
  action_ = menu.addAction(tr("Presenter mode"));
  action_->setShortcut(Qt::Key_F5);
  action_->setCheckable(true);
  const QString help = tr("The view in full screen, with large type, for an audience; Esc leaves");
  action_->setToolTip(QString("%1 (%2)").arg(help, action_->shortcut().toString(QKeySequence::NativeText)));
  action_->setStatusTip(help);
  connect(action_, &QAction::triggered, this, &Presentation::set_on);
}

double Presentation::scale() const {
  return kTypeScale * std::clamp(window_.screen()->size().height() / kPlainHeight, 1.0, 2.0);
}

void Presentation::set_on(bool on) {
  if (on == on_) return;
  on_ = on;
  if (action_ != nullptr) action_->setChecked(on);
  escape_->setEnabled(on);
  if (on) {
    enter();
  } else {
    leave();
  }
  emit changed(on, on ? scale() : 1);
}

void Presentation::enter() {
  returning_ = false;
  before_ = {window_.geometry(), window_.windowState(), window_.saveState(), !window_.statusBar()->isHidden(),
             QApplication::focusWidget()};
  for (auto* dock : window_.findChildren<QDockWidget*>()) dock->hide();
  for (auto* bar : window_.findChildren<QToolBar*>()) bar->hide();
  window_.statusBar()->hide();
  // Keys of menus act only while the menu bar is there.
  window_.menuBar()->setFixedHeight(0);
  QFont large;
  large.setPointSizeF(scale() * QApplication::font().pointSizeF());
  window_.centralWidget()->setFont(large);
  headline_.show();
  focus_.setFocus(Qt::OtherFocusReason);
  window_.setWindowState(window_.windowState() | Qt::WindowFullScreen);
}

void Presentation::leave() {
  headline_.hide();
  window_.centralWidget()->setFont(QFont());
  window_.menuBar()->setMinimumHeight(0);
  window_.menuBar()->setMaximumHeight(QWIDGETSIZE_MAX);
  window_.statusBar()->setVisible(before_.status_bar);
  window_.setWindowState(before_.state);
  if (before_.state == Qt::WindowNoState) window_.setGeometry(before_.geometry);
  window_.restoreState(before_.layout);
  returning_ = window_.size() != before_.geometry.size();
  if (before_.focus != nullptr) before_.focus->setFocus(Qt::OtherFocusReason);
}

// Window managers give the size back later; docks get theirs then.
bool Presentation::eventFilter(QObject* watched, QEvent* event) {
  if (returning_ && event->type() == QEvent::Resize && window_.size() == before_.geometry.size()) {
    returning_ = false;
    window_.restoreState(before_.layout);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace netpocket
