#pragma once
// The menu Edit: undoing, going through the history, reverting, comparing, putting parts in.

#include <QObject>
#include <QPointer>

#include "gui/workbench/editor/scenario_document.h"

class QDialog;
class QMenu;
class QWidget;

namespace netpocket {

class DifferencesDialog;
class PartDialog;

class EditActions : public QObject {
  Q_OBJECT
 public:
  // The document must outlive the actions.
  EditActions(ScenarioDocument& document, QWidget* window);

  void fill(QMenu& menu);
  QAction* revert_action() const { return revert_; }

  // Each is made when it is shown for the first time, and stays open beside the window.
  DifferencesDialog* show_differences();
  PartDialog* show_parts();
  QDialog* show_history();

 signals:
  void key_chosen(const QString& key);
  void problem(const QString& sentence);
  void told(const QString& sentence);  // what has been done

 private:
  QAction* add(QMenu& menu, const QString& text, const QKeySequence& key, const QString& help);
  void revert();
  void refresh();

  ScenarioDocument& document_;
  QWidget* window_;
  QAction* revert_ = nullptr;
  QPointer<DifferencesDialog> differences_;
  QPointer<PartDialog> parts_;
  QPointer<QDialog> history_;
};

}  // namespace netpocket
