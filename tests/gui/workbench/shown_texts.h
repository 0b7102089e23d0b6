#pragma once
// All texts that a window shows or tells on demand.

#include <QStringList>
#include <QWidget>
#include <functional>

namespace netpocket {

struct ShownText {
  QString place;  // "QPushButton tool tip"
  QString text;
};

// Of a widget and what is in it, also what is hidden now: texts, tool tips, status tips, accessible names and
// descriptions, place holders, items of menus, lists, tables and choices. Not what users write: lines and pages to
// edit.
QList<ShownText> shown_texts(const QWidget& top);

}  // namespace netpocket
