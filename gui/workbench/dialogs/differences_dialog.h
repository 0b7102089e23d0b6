#pragma once
// What differs between the open scenario and another one: the saved version, one that comes with the program, or any
// file. Stays open beside the window and follows the edits.

#include <QDialog>

#include "gui/workbench/editor/scenario_document.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace netpocket {

class DifferenceTable;

class DifferencesDialog : public QDialog {
  Q_OBJECT
 public:
  // The document must outlive the dialog.
  DifferencesDialog(ScenarioDocument& document, QWidget* parent);

  // Compares with a scenario that comes with the program, by its name.
  void compare_with(const QString& preset);
  void compare_with_saved();
  // Compares with a file; what is wrong with it is shown.
  void compare_with_file(const QString& path);
  DifferenceTable* table() const { return table_; }
  // The sentence above the table.
  QString summary() const;
  // Gives the selected parameters their values of the other scenario, as one edit.
  void take_selected();

 signals:
  void key_chosen(const QString& key);

 private:
  void choose(int index);
  void ask_for_file();
  void refresh();
  const Scenario& other() const { return other_ ? *other_ : document_.saved_scenario(); }

  ScenarioDocument& document_;
  QComboBox* choice_;
  QLabel* summary_;
  DifferenceTable* table_;
  QPushButton* take_;
  std::optional<Scenario> other_;  // absent: the saved version
};

}  // namespace netpocket
