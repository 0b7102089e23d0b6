#include "tests/gui/workbench/shown_texts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QTabBar>

namespace netpocket {
namespace {

class TextCollector {
 public:
  void add_widget(const QWidget& widget) {
    const QString kind = widget.metaObject()->className();
    add(kind + " title", widget.windowTitle());
    add(kind + " tool tip", widget.toolTip());
    add(kind + " status tip", widget.statusTip());
    add(kind + " accessible name", widget.accessibleName());
    add(kind + " accessible description", widget.accessibleDescription());
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) add(kind, label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) add(kind, button->text());
    if (const auto* box = qobject_cast<const QGroupBox*>(&widget)) add(kind, box->title());
    if (const auto* edit = qobject_cast<const QLineEdit*>(&widget))
      add(kind + " place holder", edit->placeholderText());
    if (const auto* number = qobject_cast<const QSpinBox*>(&widget)) add(kind + " suffix", number->suffix());
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&widget)) add(kind + " suffix", number->suffix());
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
      for (int i = 0; i < tabs->count(); ++i) add(kind, tabs->tabText(i));
    }
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget)) {
      for (int i = 0; i < choice->count(); ++i) add(kind + " " + choice->accessibleName(), choice->itemText(i));
      add(kind + " place holder", choice->placeholderText());
    }
    const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
    const bool of_choice = widget.window()->windowType() == Qt::Popup;  // its items are told already
    if (view != nullptr && view->model() != nullptr && !of_choice) add_items(kind, *view->model(), {});
    for (const QAction* action : widget.actions()) add_action(*action);
  }

  QList<ShownText> found;

 private:
  void add(const QString& place, const QString& text) {
    if (!text.isEmpty()) found << ShownText{place, text};
  }

  void add_action(const QAction& action) {
    add("QAction", action.text());
    add("QAction tool tip", action.toolTip());
    add("QAction status tip", action.statusTip());
  }

  void add_items(const QString& kind, const QAbstractItemModel& model, const QModelIndex& parent) {
    for (int column = 0; column < model.columnCount(parent); ++column) {
      add(kind + " head", model.headerData(column, Qt::Horizontal).toString());
      for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, column, parent);
        for (const int role :
             {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole, Qt::AccessibleDescriptionRole}) {
          add(QString("%1 item, role %2").arg(kind).arg(role), index.data(role).toString());
        }
      }
    }
  }
};

}  // namespace

QList<ShownText> shown_texts(const QWidget& top) {
  TextCollector collector;
  collector.add_widget(top);
  for (const auto* widget : top.findChildren<QWidget*>()) collector.add_widget(*widget);
  return collector.found;
}

}  // namespace netpocket
