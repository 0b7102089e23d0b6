#include "gui/workbench/editor/parameter_form.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/workbench/editor/closing_preview.h"
#include "gui/workbench/editor/group_box.h"
#include "gui/workbench/editor/parameter_field.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

constexpr int kStepPause = 700;  // ms without a step after which the next one is an edit of its own

}  // namespace

ParameterForm::ParameterForm(ScenarioDocument* document, QWidget* parent) : QScrollArea(parent), document_(document) {
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);  // its fields take the keys
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  stepping_.setSingleShot(true);
  stepping_.setInterval(kStepPause);
  connect(&stepping_, &QTimer::timeout, document_, &ScenarioDocument::end_interaction);
  build();
  connect(document_, &ScenarioDocument::changed, this, &ParameterForm::refresh);
  connect(document_, &ScenarioDocument::saved_changed, this, &ParameterForm::refresh);
  connect(document_, &ScenarioDocument::diagnostics_changed, this, &ParameterForm::show_problems);
  refresh();
  show_problems();
}

ParameterForm::~ParameterForm() {
  if (stepping_.isActive()) document_->end_interaction();
}

// Rows may be narrow but are never cut.
QSize ParameterForm::minimumSizeHint() const {
  const int bar = verticalScrollBar()->sizeHint().width();
  return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
}

// Another kind of capture system has other parameters.
void ParameterForm::rebuild() {
  sections_.clear();
  rows_.clear();
  groups_.clear();
  preview_ = nullptr;
  // The edit that leads here may come from one of the rows.
  if (QWidget* old = takeWidget()) old->deleteLater();
  build();
}

void ParameterForm::build() {
  system_ = document_->scenario().system;
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 8);
  layout->setSpacing(0);
  for (const ParameterGroup& group : parameter_groups(system_)) {
    auto* box = new GroupBox(title(group), help(group), content);
    Section section{box, {}};
    // In front of its parameters, so that it stays in sight while they are edited.
    if (group.name == "closing") {
      preview_ = new ClosingPreview(box);
      box->add(preview_);
    }
    for (const Parameter& parameter : parameters_of(group, system_)) add_row(section, parameter);
    layout->addWidget(box);
    groups_[from_utf8(group.name)] = box;
    sections_.push_back(std::move(section));
  }
  layout->addStretch();
  setWidget(content);
}

void ParameterForm::add_row(Section& section, const Parameter& parameter) {
  if (parameter.key == "system" && parameter.choices.size() == 1) return;  // nothing to choose
  auto* row = new ParameterRow(parameter, section.box, system_);
  section.box->add(row);
  section.rows.push_back(row);
  rows_[from_utf8(parameter.key)] = row;
  connect(row, &ParameterRow::edited, this,
          [this, &parameter](const ParameterValue& value, bool stepped) { edit(parameter, value, stepped); });
  connect(row, &ParameterRow::tried, this,
          [this, &parameter](const ParameterValue& value) { try_out(parameter, value); });
  for (QLineEdit* edit : row->findChildren<QLineEdit*>()) edit->installEventFilter(this);
}

void ParameterForm::edit(const Parameter& parameter, const ParameterValue& value, bool stepped) {
  if (stepped) {
    if (!stepping_.isActive()) document_->begin_interaction();
    stepping_.start();
  } else if (stepping_.isActive()) {
    stepping_.stop();
    document_->end_interaction();
  }
  const auto problem = document_->set_value(parameter, value);
  if (!problem) refresh();  // also when the value is the same: what was typed is over
}

void ParameterForm::try_out(const Parameter& parameter, const ParameterValue& value) {
  Scenario scenario = document_->scenario();
  parameter.set(scenario, value);
  if (preview_ != nullptr) preview_->show_scenario(scenario);
  emit tried(scenario);
}

void ParameterForm::refresh() {
  if (document_->scenario().system != system_) rebuild();
  for (const auto& [key, row] : rows_) row->show_scenario(document_->scenario(), document_->saved_scenario());
  if (preview_ != nullptr) preview_->show_scenario(document_->scenario());
  show_counts();
  emit tried(document_->scenario());
}

void ParameterForm::show_problems() {
  std::map<QString, QStringList> problems;
  for (const Diagnostic& diagnostic : document_->diagnostics().list()) {
    // Some problems are those of a group; they stand at its first parameter.
    const auto* group = find_parameter_group(diagnostic.key, system_);
    const auto key = group && !group->name.empty() ? from_utf8(parameters_of(*group, system_).front().key)
                                                   : QString::fromStdString(diagnostic.key);
    QString message = engine_words(diagnostic.message);
    if (!message.isEmpty()) message[0] = message[0].toUpper();
    problems[key] << tr("%1.").arg(message);
  }
  for (const auto& [key, row] : rows_) row->set_problem(problems.contains(key) ? problems[key].join('\n') : QString());
  show_counts();
}

void ParameterForm::show_counts() {
  for (const Section& section : sections_) {
    const auto count = [&section](auto property) {
      return static_cast<int>(std::count_if(section.rows.begin(), section.rows.end(), property));
    };
    section.box->set_counts(count([](const ParameterRow* row) { return row->is_changed(); }),
                            count([](const ParameterRow* row) { return !row->problem().isEmpty(); }));
  }
}

int ParameterForm::filter(const QString& words, bool changed_only) {
  const QStringList wanted = words.toLower().split(' ', Qt::SkipEmptyParts);
  const bool filters = !wanted.isEmpty() || changed_only;
  int shown = 0;
  for (const Section& section : sections_) {
    int shown_here = 0;
    for (ParameterRow* row : section.rows) {
      const bool matches = row->matches(wanted) && (!changed_only || row->is_changed());
      row->setVisible(matches);
      shown_here += matches ? 1 : 0;
    }
    section.box->setVisible(shown_here > 0);
    section.box->force_open(filters);
    shown += shown_here;
  }
  if (preview_ != nullptr) preview_->setVisible(!filters || words.contains("clos", Qt::CaseInsensitive));
  return shown;
}

void ParameterForm::reveal(const QString& key) {
  ParameterRow* row = this->row(key);
  if (!row) return;
  if (GroupBox* box = group(from_utf8(row->parameter().group()))) box->set_expanded(true);
  ensureWidgetVisible(row);
  row->field()->setFocus(Qt::TabFocusReason);
}

void ParameterForm::focus_first() {
  for (const Section& section : sections_) {
    for (ParameterRow* row : section.rows) {
      if (row->isHidden() || !row->field()->isEnabled()) continue;
      return reveal(from_utf8(row->parameter().key));
    }
  }
}

void ParameterForm::set_running(const Scenario* running) {
  for (const auto& [key, row] : rows_) row->set_running(running);
}

void ParameterForm::set_read_only(bool read_only) {
  for (const auto& [key, row] : rows_) row->set_read_only(read_only);
}

ParameterRow* ParameterForm::row(const QString& key) const {
  const auto found = rows_.find(key);
  return found == rows_.end() ? nullptr : found->second;
}

GroupBox* ParameterForm::group(const QString& name) const {
  const auto found = groups_.find(name);
  return found == groups_.end() ? nullptr : found->second;
}

QStringList ParameterForm::keys_that_need_restart() const {
  QStringList keys;
  for (const auto& [key, row] : rows_) {
    if (row->needs_restart()) keys << key;
  }
  return keys;
}

// A line edit would keep undo and redo to itself. It may as long as something is being typed; else they are the
// document's.
bool ParameterForm::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool history = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
    const auto* edit = qobject_cast<QLineEdit*>(watched);
    if (history && edit && !edit->isModified()) {
      event->ignore();
      return true;
    }
  }
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace netpocket
