#pragma once
// Defines a campaign for the scenario that is being edited: what is uncertain, how many captures, what to estimate. The
// study's file has everything else.

#include <QWidget>
#include <vector>

#include "gui/workbench/campaign/study_draft.h"
#include "gui/workbench/editor/scenario_document.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace netpocket {

class NumberEdit;
class ScatterRow;

class StudyForm : public QWidget {
  Q_OBJECT
 public:
  // The document must outlive the form.
  explicit StudyForm(ScenarioDocument& document, QWidget* parent = nullptr);

  // Without a base.
  StudyDraft draft() const;
  void set_draft(const StudyDraft& draft);
  void add_input(const DraftInput& input);
  int jobs() const;
  void set_jobs(int jobs);

  const std::vector<ScatterRow*>& rows() const { return rows_; }
  QSpinBox* samples() const { return samples_; }
  QPushButton* run_button() const { return run_; }
  QPushButton* save_button() const { return save_; }
  QPushButton* open_study_button() const { return open_study_; }
  QPushButton* open_folder_button() const { return open_folder_; }

 private:
  QWidget* make_inputs();
  QWidget* make_size();
  QWidget* make_buttons();
  void fill_keys();
  void add_chosen_key();
  void show_scenario();
  void show_estimate();

  ScenarioDocument& document_;
  std::string system_;
  std::vector<ScatterRow*> rows_;
  QVBoxLayout* rows_layout_;
  QComboBox *keys_, *sampling_;
  QSpinBox *samples_, *seed_, *jobs_;
  QToolButton* estimate_;
  QCheckBox* ends_early_;
  NumberEdit* half_width_;
  QPushButton *run_, *save_, *open_study_, *open_folder_;
};

}  // namespace netpocket
