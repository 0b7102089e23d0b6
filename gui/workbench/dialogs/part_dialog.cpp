#include "gui/workbench/dialogs/part_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/workbench/editor/difference_table.h"
#include "gui/workbench/start/card_delegate.h"

namespace netpocket {

PartDialog::PartDialog(ScenarioDocument& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      part_(new QComboBox),
      list_(new QListWidget),
      summary_(new QLabel),
      table_(new DifferenceTable(tr("Now"), tr("Then"))),
      apply_(new QPushButton(tr("&Apply"))) {
  setWindowTitle(tr("Pockets, targets, strategies"));
  part_->addItems({tr("Pocket"), tr("Target"), tr("Strategy")});
  part_->setAccessibleName(tr("Part of the scenario"));
  list_->setAccessibleName(tr("Presets"));
  list_->setItemDelegate(new CardDelegate({}, list_));
  summary_->setWordWrap(true);
  apply_->setToolTip(tr("Make these changes, as one step of the history"));
  auto* left = new QWidget;
  auto* left_layout = new QVBoxLayout(left);
  left_layout->setContentsMargins(0, 0, 0, 0);
  left_layout->addWidget(part_);
  left_layout->addWidget(list_, 1);
  auto* right = new QWidget;
  auto* right_layout = new QVBoxLayout(right);
  right_layout->setContentsMargins(0, 0, 0, 0);
  right_layout->addWidget(summary_);
  right_layout->addWidget(table_, 1);
  auto* split = new QSplitter;
  split->setChildrenCollapsible(false);
  split->addWidget(left);
  split->addWidget(right);
  split->setSizes({280, 560});
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->addButton(apply_, QDialogButtonBox::ApplyRole);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(split, 1);
  layout->addWidget(buttons);
  connect(part_, &QComboBox::currentIndexChanged, this, &PartDialog::fill);
  connect(list_, &QListWidget::currentItemChanged, this, &PartDialog::preview);
  connect(apply_, &QPushButton::clicked, this, &PartDialog::apply);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(table_, &DifferenceTable::key_chosen, this, &PartDialog::key_chosen);
  connect(&document_, &ScenarioDocument::changed, this, &PartDialog::preview);
  resize(880, 460);
  fill();
}

ScenarioPart PartDialog::part() const { return static_cast<ScenarioPart>(part_->currentIndex()); }

void PartDialog::show_part(ScenarioPart part) { part_->setCurrentIndex(static_cast<int>(part)); }

void PartDialog::fill() {
  list_->clear();
  for (const PartPreset& preset : part_presets(part())) {
    auto* item = new QListWidgetItem(preset.name, list_);
    const QString summary = summary_of(part(), preset);
    item->setData(CardDelegate::kSentenceRole, summary);
    item->setData(Qt::AccessibleDescriptionRole, summary);
    item->setToolTip(summary + "\n" + tr("In: %1").arg(preset.scenarios.join(", ")));
  }
  list_->setCurrentRow(0);
}

const PartPreset* PartDialog::chosen() const {
  const int row = list_->currentRow();
  return row < 0 ? nullptr : &part_presets(part())[static_cast<std::size_t>(row)];
}

void PartDialog::preview() {
  const PartPreset* preset = chosen();
  if (preset == nullptr) return;
  Scenario then = document_.scenario();
  for (const auto& [parameter, value] : changes(*preset, document_.scenario())) parameter->set(then, value);
  table_->show_differences(differences(document_.scenario(), then));
  const auto count = static_cast<int>(table_->rows().size());
  summary_->setText(document_.scenario().system != kPocketSystem ? tr("The open scenario is of another capture system.")
                    : count == 0                                 ? tr("The scenario has these values already.")
                    : count == 1                                 ? tr("One value would change:")
                                                                 : tr("%1 values would change:").arg(count));
  apply_->setEnabled(count > 0);
}

void PartDialog::apply() {
  const PartPreset* preset = chosen();
  if (preset == nullptr) return;
  const QString text = tr("%1 of %2").arg(part_->currentText(), preset->name).toLower();
  const auto refusal = document_.set_values(changes(*preset, document_.scenario()), text);
  if (refusal) summary_->setText(*refusal);
}

}  // namespace netpocket
