#pragma once
// All keys on one page, made from the menus themselves, and what the mouse does.

#include <QDialog>

class QMenuBar;

namespace netpocket {

class ShortcutSheet : public QDialog {
  Q_OBJECT
 public:
  ShortcutSheet(const QMenuBar& menus, QWidget* parent);
};

}  // namespace netpocket
