#include "gui/workbench/dialogs/differences_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "engine/scenario/read_scenario.h"
#include "gui/workbench/editor/difference_table.h"
#include "gui/workbench/editor/presets.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {

DifferencesDialog::DifferencesDialog(ScenarioDocument& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      choice_(new QComboBox),
      summary_(new QLabel),
      table_(new DifferenceTable(tr("Here"), tr("There"))),
      take_(new QPushButton(tr("&Take selected values over"))) {
  setWindowTitle(tr("What differs"));
  choice_->addItem(tr("The saved version"));
  for (const Preset& preset : presets()) choice_->addItem(preset.name);
  choice_->setAccessibleName(tr("Compare with"));
  auto* label = new QLabel(tr("&Compare with:"));
  label->setBuddy(choice_);
  auto* file = new QPushButton(tr("Other &file…"));
  summary_->setWordWrap(true);
  take_->setToolTip(tr("Give the selected parameters their values there, as one step of the history"));
  auto* top = new QHBoxLayout;
  top->addWidget(label);
  top->addWidget(choice_, 1);
  top->addWidget(file);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->addButton(take_, QDialogButtonBox::ActionRole);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(summary_);
  layout->addWidget(table_, 1);
  layout->addWidget(buttons);
  for (auto* button : findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(choice_, &QComboBox::activated, this, &DifferencesDialog::choose);
  connect(file, &QPushButton::clicked, this, &DifferencesDialog::ask_for_file);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(take_, &QPushButton::clicked, this, &DifferencesDialog::take_selected);
  connect(table_, &DifferenceTable::key_chosen, this, &DifferencesDialog::key_chosen);
  connect(table_, &QTreeWidget::itemSelectionChanged, this,
          [this] { take_->setEnabled(!table_->selected_parameters().empty()); });
  connect(&document_, &ScenarioDocument::changed, this, &DifferencesDialog::refresh);
  connect(&document_, &ScenarioDocument::saved_changed, this, &DifferencesDialog::refresh);
  resize(760, 460);
  refresh();
}

void DifferencesDialog::choose(int index) {
  if (index <= 0) return compare_with_saved();
  compare_with(choice_->itemText(index));
}

void DifferencesDialog::compare_with_saved() {
  other_.reset();
  choice_->setCurrentIndex(0);
  refresh();
}

void DifferencesDialog::compare_with(const QString& preset) {
  for (int i = 0; i < static_cast<int>(presets().size()); ++i) {
    const Preset& candidate = presets()[static_cast<std::size_t>(i)];
    if (candidate.name != preset) continue;
    other_ = read_scenario_text(candidate.text.toStdString(), {}).scenario;
    choice_->setCurrentIndex(i + 1);
    refresh();
    return;
  }
}

void DifferencesDialog::compare_with_file(const QString& path) {
  ScenarioResult result = read_scenario_file(path.toStdString());
  if (!result.ok()) {
    summary_->setText(diagnostics_words(result.diagnostics));
    return;
  }
  other_ = std::move(result.scenario);
  const QString name = QFileInfo(path).fileName();
  choice_->setCurrentIndex(-1);
  choice_->setPlaceholderText(name);
  refresh();
}

void DifferencesDialog::ask_for_file() {
  const QString folder = document_.path().isEmpty() ? QString() : QFileInfo(document_.path()).path();
  const QString path = QFileDialog::getOpenFileName(this, tr("Compare with"), folder, tr("Scenarios (*.toml)"));
  if (!path.isEmpty()) compare_with_file(path);
}

void DifferencesDialog::refresh() {
  table_->show_differences(differences(document_.scenario(), other()));
  const auto count = static_cast<int>(table_->rows().size());
  const QString name = choice_->currentIndex() < 0 ? choice_->placeholderText() : choice_->currentText();
  summary_->setText(count == 0 ? tr("No value of %1 differs from: %2.").arg(document_.display_name(), name)
                    : count == 1
                        ? tr("One value of %1 differs from: %2.").arg(document_.display_name(), name)
                        : tr("%1 values of %2 differ from: %3.").arg(count).arg(document_.display_name(), name));
  take_->setEnabled(false);
}

void DifferencesDialog::take_selected() {
  std::vector<ScenarioDocument::Setting> settings;
  for (const Parameter* parameter : table_->selected_parameters()) {
    settings.emplace_back(parameter, parameter->get(other()));
  }
  if (settings.empty()) return;
  const auto refusal = document_.set_values(settings, tr("take %1 values over").arg(settings.size()));
  if (refusal) summary_->setText(*refusal);
}

QString DifferencesDialog::summary() const { return summary_->text(); }

}  // namespace netpocket
