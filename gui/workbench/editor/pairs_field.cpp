#include "gui/workbench/editor/pairs_field.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/workbench/editor/parameter_words.h"
#include "gui/workbench/panels/focus_frame.h"
#include "gui/workbench/panels/icons.h"

namespace netpocket {
namespace {

constexpr int kVisibleRows = 8;

// Rods, panels and ropes are counted from 1, times begin with 0.
Eigen::Vector2d first_row(const Parameter& parameter) {
  const bool counts = parameter.group() == "scatter" || parameter.group() == "winch";
  return Eigen::Vector2d::Constant(counts ? 1 : 0);
}

// What the two numbers of a row are.
QStringList titles_of(const Parameter& parameter) {
  if (parameter.key == "rods.profile") return {PairsField::tr("from axis r, m"), PairsField::tr("height y, m")};
  if (parameter.key == "scatter.panel_stiffness") return {PairsField::tr("panel"), PairsField::tr("factor")};
  if (parameter.group() == "scatter") return {PairsField::tr("rod"), PairsField::tr("factor")};
  if (parameter.group() == "winch") return {PairsField::tr("rope"), PairsField::tr("time t, s")};
  return {PairsField::tr("time t, s"), PairsField::tr("length L, m")};
}

}  // namespace

PairsField::PairsField(const Parameter& parameter, QWidget* parent)
    : ParameterField(parameter, parent), table_(new QTableWidget(0, 2, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addWidget(table_);
  const bool profile = parameter.key == "rods.profile";
  table_->setHorizontalHeaderLabels(titles_of(parameter));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setTabKeyNavigation(false);
  table_->setAccessibleName(label(parameter));
  connect(table_, &QTableWidget::cellChanged, this, &PairsField::read_cell);
  setFocusProxy(table_);
  new FocusFrame(table_);  // an empty table has no cell that could show it
  if (profile) return;

  add_ = new QToolButton(this);
  add_->setToolTip(tr("Add a row below"));
  add_->setAccessibleName(add_->toolTip());
  remove_ = new QToolButton(this);
  remove_->setToolTip(tr("Remove the row"));
  remove_->setAccessibleName(remove_->toolTip());
  connect(add_, &QToolButton::clicked, this, &PairsField::add_row);
  connect(remove_, &QToolButton::clicked, this, &PairsField::remove_row);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_);
  buttons->addWidget(remove_);
  buttons->addStretch();
  layout->addLayout(buttons);
  set_icons();
}

void PairsField::set_icons() {
  if (!add_) return;
  add_->setIcon(glyph_icon(Glyph::add, Tone::muted, palette()));
  remove_->setIcon(glyph_icon(Glyph::remove, Tone::muted, palette()));
}

void PairsField::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) set_icons();
  ParameterField::changeEvent(event);
}

void PairsField::show_value(const ParameterValue& value) {
  pairs_ = std::get<Pairs>(value);
  fill();
}

void PairsField::fill() {
  filling_ = true;
  table_->setRowCount(static_cast<int>(pairs_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int column = 0; column < 2; ++column) {
      auto* item = new QTableWidgetItem(number_words(pairs_[row][column]));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
  }
  if (!add_) table_->setVerticalHeaderLabels({tr("root"), tr("kink"), tr("tip")});
  if (remove_) remove_->setEnabled(!pairs_.empty() && add_->isEnabled());
  filling_ = false;
  fit_height();
}

void PairsField::fit_height() {
  const int rows = std::clamp(table_->rowCount(), 1, kVisibleRows);
  const int header = table_->horizontalHeader()->sizeHint().height();
  table_->setFixedHeight(header + rows * table_->verticalHeader()->defaultSectionSize() + 2 * table_->frameWidth());
}

void PairsField::set_read_only(bool read_only) {
  table_->setEditTriggers(read_only ? QAbstractItemView::NoEditTriggers
                                    : QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                                          QAbstractItemView::AnyKeyPressed);
  if (add_) add_->setEnabled(!read_only);
  if (remove_) remove_->setEnabled(!read_only && !pairs_.empty());
}

void PairsField::read_cell(int row, int column) {
  if (filling_) return;
  bool valid = false;
  const QString text = table_->item(row, column)->text().trimmed().replace(',', '.');
  const double number = text.toDouble(&valid);
  if (!valid) {
    emit refused(tr("“%1” is not a number.").arg(text));
    return;
  }
  Pairs next = pairs_;
  next[row][column] = number;
  offer(next, Step::typed);
}

// A new row continues as the last two rows go.
void PairsField::add_row() {
  Pairs next = pairs_;
  const int current = table_->currentRow();
  const std::size_t after = current >= 0 ? current + 1 : next.size();
  Eigen::Vector2d row = next.empty() ? first_row(parameter()) : next[after - 1];
  if (after < next.size()) {
    row = (row + next[after]) / 2;
  } else if (!next.empty()) {
    row.x() += next.size() > 1 ? next.back().x() - next[next.size() - 2].x() : 1;
  }
  next.insert(next.begin() + static_cast<std::ptrdiff_t>(after), row);
  offer(next, Step::typed);
  table_->setCurrentCell(static_cast<int>(after), 0);
}

void PairsField::remove_row() {
  Pairs next = pairs_;
  const int current = table_->currentRow();
  next.erase(next.begin() + (current >= 0 ? current : static_cast<int>(next.size()) - 1));
  offer(next, Step::typed);
}

}  // namespace netpocket
