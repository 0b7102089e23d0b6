#include "gui/workbench/control/gain_form.h"

#include <QLabel>
#include <QVBoxLayout>

#include "gui/workbench/editor/parameter_field.h"
#include "gui/workbench/editor/parameter_row.h"
#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

constexpr int kStepPause = 700;  // ms without a step after which the next one is an edit of its own

}  // namespace

GainForm::GainForm(ScenarioDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), layout_(new QVBoxLayout(this)), nothing_(new QLabel(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(0);
  nothing_->setWordWrap(true);
  nothing_->setMargin(12);
  nothing_->setForegroundRole(QPalette::PlaceholderText);
  nothing_->setText(tr("The edited scenario has no such table: its gains cannot be changed here."));
  layout_->addWidget(nothing_);
  stepping_.setSingleShot(true);
  stepping_.setInterval(kStepPause);
  connect(&stepping_, &QTimer::timeout, &document_, &ScenarioDocument::end_interaction);
  connect(&document_, &ScenarioDocument::changed, this, &GainForm::refresh);
  connect(&document_, &ScenarioDocument::saved_changed, this, &GainForm::refresh);
  connect(&document_, &ScenarioDocument::diagnostics_changed, this, &GainForm::show_problems);
  build();
}

GainForm::~GainForm() {
  if (stepping_.isActive()) document_.end_interaction();
}

void GainForm::show_table(const QString& table) {
  if (table == table_) return;
  table_ = table;
  build();
}

// Those of the table that the loop, as it is, uses.
std::vector<const Parameter*> GainForm::wanted() const {
  std::vector<const Parameter*> found;
  const QString prefix = table_ + ".";
  for (const Parameter* parameter : parameters_of(document_.scenario())) {
    const bool belongs = !table_.isEmpty() && from_utf8(parameter->key).startsWith(prefix);
    if (belongs && !why_unused(*parameter, document_.scenario())) found.push_back(parameter);
  }
  return found;
}

void GainForm::build() {
  for (ParameterRow* row : rows_) {
    row->hide();
    row->deleteLater();  // the edit that leads here may come from it
  }
  rows_.clear();
  for (const Parameter* parameter : wanted()) {
    auto* row = new ParameterRow(*parameter, this, document_.scenario().system);
    layout_->addWidget(row);
    rows_.push_back(row);
    connect(row, &ParameterRow::edited, this,
            [this, parameter](const ParameterValue& value, bool stepped) { edit(*parameter, value, stepped); });
    row->show_scenario(document_.scenario(), document_.saved_scenario());
    row->set_running(running_ ? &*running_ : nullptr);
    row->show();
  }
  nothing_->setVisible(rows_.empty() && !table_.isEmpty());
  show_problems();
}

void GainForm::show_problems() {
  for (ParameterRow* row : rows_) {
    QStringList problems;
    for (const Diagnostic& diagnostic : document_.diagnostics().list()) {
      if (diagnostic.key != row->parameter().key || diagnostic.message.empty()) continue;
      QString message = engine_words(diagnostic.message);
      message[0] = message[0].toUpper();
      problems << tr("%1.").arg(message);
    }
    row->set_problem(problems.join('\n'));
  }
}

void GainForm::refresh() {
  std::vector<const Parameter*> shown;
  for (const ParameterRow* row : rows_) shown.push_back(&row->parameter());
  if (shown != wanted()) return build();
  for (ParameterRow* row : rows_) row->show_scenario(document_.scenario(), document_.saved_scenario());
}

void GainForm::edit(const Parameter& parameter, const ParameterValue& value, bool stepped) {
  if (stepped) {
    if (!stepping_.isActive()) document_.begin_interaction();
    stepping_.start();
  } else if (stepping_.isActive()) {
    stepping_.stop();
    document_.end_interaction();
  }
  if (!document_.set_value(parameter, value)) refresh();
}

void GainForm::set_running(const Scenario* running) {
  running_ = running != nullptr ? std::optional(*running) : std::nullopt;
  for (ParameterRow* row : rows_) row->set_running(running);
}

ParameterRow* GainForm::row(const QString& key) const {
  for (ParameterRow* row : rows_) {
    if (from_utf8(row->parameter().key) == key) return row;
  }
  return nullptr;
}

}  // namespace netpocket
