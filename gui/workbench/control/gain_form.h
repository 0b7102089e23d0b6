#pragma once
// The parameters of one control loop as fields: gains and set points act on a run at once, the rest says that it needs
// a restart. Edits go into the document, as those of the form do.

#include <QTimer>
#include <QWidget>
#include <vector>

#include "gui/workbench/editor/scenario_document.h"

class QLabel;
class QVBoxLayout;

namespace netpocket {

class ParameterRow;

class GainForm : public QWidget {
  Q_OBJECT
 public:
  explicit GainForm(ScenarioDocument& document, QWidget* parent = nullptr);
  ~GainForm() override;

  // Table of the loop in the scenario ("controller.0"); empty: none.
  void show_table(const QString& table);
  void set_running(const Scenario* running);
  // Null if it is not shown.
  ParameterRow* row(const QString& key) const;

 private:
  void build();
  void refresh();
  void show_problems();
  void edit(const Parameter& parameter, const ParameterValue& value, bool stepped);
  std::vector<const Parameter*> wanted() const;

  ScenarioDocument& document_;
  QString table_;
  std::vector<ParameterRow*> rows_;
  QVBoxLayout* layout_;
  QLabel* nothing_;
  std::optional<Scenario> running_;
  QTimer stepping_;  // runs while steps follow each other and so belong together
};

}  // namespace netpocket
