#pragma once
// One parameter in the form: label, field, unit, what it means to a run, reset; and under it what is wrong.

#include <QWidget>
#include <optional>
#include <span>

#include "engine/scenario/parameters.h"
#include "gui/workbench/editor/parameter_words.h"

class QGridLayout;
class QLabel;
class QToolButton;

namespace netpocket {

class ParameterField;

class ParameterRow : public QWidget {
  Q_OBJECT
 public:
  // `system`: kind of capture system that the parameter belongs to.
  explicit ParameterRow(const Parameter& parameter, QWidget* parent = nullptr, std::string_view system = kPocketSystem);

  const Parameter& parameter() const { return parameter_; }
  ParameterField* field() const { return field_; }

  // The scenario, and that of the file, which a change is measured against.
  void show_scenario(const Scenario& scenario, const Scenario& saved);
  // From checking the scenario as a whole; empty when all is well.
  void set_problem(const QString& problem);
  // The scenario that runs now: marks what edits mean to it. Null: nothing runs.
  void set_running(const Scenario* running);
  void set_read_only(bool read_only);

  // What stands under the field; empty when nothing is wrong.
  QString problem() const;
  bool is_changed() const { return changed_; }
  // Whether the run in progress has another value, which takes a restart.
  bool needs_restart() const { return needs_restart_; }
  // Whether every word occurs in the names, help, unit or source.
  bool matches(const QStringList& words) const;
  // Click on it to go back to the file's value or, if that is it, to the default.
  QToolButton* reset_button() const { return reset_; }

  // Widths of the columns, so that all rows of a form align.
  int label_width(const QFontMetrics& metrics) const;
  int unit_width(const QFontMetrics& metrics) const;

  QSize minimumSizeHint() const override;

 signals:
  void edited(const ParameterValue& value, bool stepped);
  void tried(const ParameterValue& value);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::span<const Parameter> siblings() const;
  void lay_out();
  void place_field();
  void show_label();
  void show_reset();
  void show_effect();
  void show_problem();

  const Parameter& parameter_;
  ParameterField* field_;
  QGridLayout* layout_;
  QLabel* label_;
  QLabel* unit_;
  QLabel* effect_;
  QToolButton* reset_;
  QLabel* problem_;
  ParameterValue value_;
  ParameterValue saved_;
  std::string system_;
  std::optional<ParameterValue> running_;
  std::optional<QString> unused_;
  QString typed_problem_;
  QString document_problem_;
  QString search_text_;
  bool changed_ = false;
  bool needs_restart_ = false;
  bool read_only_ = false;
  std::optional<bool> field_below_;  // instead of beside the label
};

}  // namespace netpocket
