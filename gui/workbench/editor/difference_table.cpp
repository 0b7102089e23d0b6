#include "gui/workbench/editor/difference_table.h"

#include <QHeaderView>

namespace netpocket {
namespace {

enum Column { kName, kHere, kThere, kUnit, kKey };

constexpr int kRowPadding = 8;  // pixels
constexpr int kLetters = 18;    // widest number columns, in letters
constexpr int kNameLetters = 30;

}  // namespace

DifferenceTable::DifferenceTable(const QString& here, const QString& there, QWidget* parent) : QTreeWidget(parent) {
  setHeaderLabels({tr("Parameter"), here, there, tr("Unit"), tr("Key")});
  setAccessibleName(tr("Differences"));
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  setSelectionMode(ExtendedSelection);
  setVerticalScrollMode(ScrollPerPixel);
  const int letter = fontMetrics().averageCharWidth();
  header()->resizeSection(kName, kNameLetters * letter);
  header()->resizeSection(kHere, kLetters * letter);
  header()->resizeSection(kThere, kLetters * letter);
  header()->setSectionResizeMode(kUnit, QHeaderView::ResizeToContents);
  const auto choose = [this](QTreeWidgetItem* item) { emit key_chosen(item->text(kKey)); };
  connect(this, &QTreeWidget::itemClicked, this, choose);
  connect(this, &QTreeWidget::itemActivated, this, choose);
}

void DifferenceTable::show_differences(std::vector<ScenarioDifference> rows) {
  rows_ = std::move(rows);
  clear();
  for (const ScenarioDifference& row : rows_) {
    auto* item = new QTreeWidgetItem(this, {row.name, row.here, row.there, row.unit, row.key});
    item->setSizeHint(kName, QSize(0, fontMetrics().height() + kRowPadding));
    for (const int column : {kName, kHere, kThere}) item->setToolTip(column, item->text(column));
    for (const int column : {kHere, kThere}) item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
}

std::vector<const Parameter*> DifferenceTable::selected_parameters() const {
  std::vector<const Parameter*> found;
  for (const QTreeWidgetItem* item : selectedItems()) {
    const auto index = static_cast<std::size_t>(indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item)));
    if (rows_[index].parameter != nullptr) found.push_back(rows_[index].parameter);
  }
  return found;
}

}  // namespace netpocket
