#pragma once
// A table of what differs between two scenarios: parameter, value here, value there, unit, key.

#include <QTreeWidget>

#include "gui/workbench/editor/scenario_difference.h"

namespace netpocket {

class DifferenceTable : public QTreeWidget {
  Q_OBJECT
 public:
  // What the columns of the two scenarios are called.
  DifferenceTable(const QString& here, const QString& there, QWidget* parent = nullptr);

  void show_differences(std::vector<ScenarioDifference> rows);
  const std::vector<ScenarioDifference>& rows() const { return rows_; }
  // Those of the selected rows that are parameters of both scenarios.
  std::vector<const Parameter*> selected_parameters() const;

 signals:
  void key_chosen(const QString& key);  // by a click or Enter

 private:
  std::vector<ScenarioDifference> rows_;
};

}  // namespace netpocket
