#pragma once
// An uncertain input in the form of a campaign: how and by how much it scatters about the scenario's value.

#include <QWidget>

#include "gui/workbench/campaign/study_draft.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace netpocket {

class NumberEdit;

class ScatterRow : public QWidget {
  Q_OBJECT
 public:
  ScatterRow(const DraftInput& input, const Scenario& scenario, QWidget* parent = nullptr);

  DraftInput input() const;
  // The centre is another one, or the key has gone.
  void show_scenario(const Scenario& scenario);

  QComboBox* scatter() const { return scatter_; }
  NumberEdit* spread() const { return spread_; }
  QToolButton* remove_button() const { return remove_; }

 signals:
  void remove_requested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_unit();
  void show_glyph();

  std::string key_;
  QString unit_words_;  // of the parameter
  QLabel *name_, *unit_;
  QComboBox* scatter_;
  NumberEdit* spread_;
  QToolButton* remove_;
};

// "Target: position x" for "target.position[0]".
QString scatter_label(const Scenario& scenario, const std::string& key);

}  // namespace netpocket
