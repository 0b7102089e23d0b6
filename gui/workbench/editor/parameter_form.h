#pragma once
// The form of a scenario, generated from the parameter table.

#include <QScrollArea>
#include <QTimer>
#include <map>
#include <optional>
#include <vector>

#include "gui/workbench/editor/scenario_document.h"

namespace netpocket {

class ClosingPreview;
class GroupBox;
class ParameterRow;

class ParameterForm : public QScrollArea {
  Q_OBJECT
 public:
  explicit ParameterForm(ScenarioDocument* document, QWidget* parent = nullptr);
  ~ParameterForm() override;

  // Shows only rows that match all words and, if wished, have changed since the file was saved. How many are shown.
  int filter(const QString& words, bool changed_only);
  // Unfolds, scrolls to and focuses a parameter.
  void reveal(const QString& key);
  void focus_first();

  void set_running(const Scenario* running);
  void set_read_only(bool read_only);

  // Null if there is no such parameter.
  ParameterRow* row(const QString& key) const;
  GroupBox* group(const QString& name) const;
  // Null if the system has no closing law.
  ClosingPreview* closing_preview() const { return preview_; }
  // Changed values that the run in progress takes up only after a restart.
  QStringList keys_that_need_restart() const;

  QSize minimumSizeHint() const override;

 signals:
  // The scenario as it would be with what is being typed; also sent when typing ends.
  void tried(const netpocket::Scenario& scenario);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Section {
    GroupBox* box;
    std::vector<ParameterRow*> rows;
  };

  void build();
  void rebuild();
  void add_row(Section& section, const Parameter& parameter);
  void edit(const Parameter& parameter, const ParameterValue& value, bool stepped);
  void try_out(const Parameter& parameter, const ParameterValue& value);
  void refresh();
  void show_problems();
  void show_counts();

  ScenarioDocument* document_;
  std::string system_;  // kind of capture system whose parameters are shown
  std::vector<Section> sections_;
  std::map<QString, ParameterRow*> rows_;
  std::map<QString, GroupBox*> groups_;
  ClosingPreview* preview_ = nullptr;  // null: the system has no closing law
  QTimer stepping_;                    // runs while steps follow each other and so belong together
};

}  // namespace netpocket
