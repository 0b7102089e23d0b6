#pragma once
// Puts a pocket, a target or a strategy of a scenario that comes with the program into the open one; shows first what
// that would change. Stays open beside the window and follows the edits.

#include <QDialog>

#include "gui/workbench/editor/part_presets.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace netpocket {

class DifferenceTable;

class PartDialog : public QDialog {
  Q_OBJECT
 public:
  // The document must outlive the dialog.
  PartDialog(ScenarioDocument& document, QWidget* parent);

  void show_part(ScenarioPart part);
  QListWidget* list() const { return list_; }
  DifferenceTable* table() const { return table_; }
  QPushButton* apply_button() const { return apply_; }

 signals:
  void key_chosen(const QString& key);

 private:
  void fill();
  void preview();
  void apply();
  const PartPreset* chosen() const;
  ScenarioPart part() const;

  ScenarioDocument& document_;
  QComboBox* part_;
  QListWidget* list_;
  QLabel* summary_;
  DifferenceTable* table_;
  QPushButton* apply_;
};

}  // namespace netpocket
