#include "gui/workbench/control/loop_values.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <cmath>

namespace netpocket {

LoopValues::LoopValues(QWidget* parent) : QWidget(parent) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(12, 2, 6, 2);
  layout->setHorizontalSpacing(8);
  layout->setVerticalSpacing(1);
  for (const char* head : {"", "x", "y", "z", ""}) {
    auto* label = new QLabel(head, this);
    label->setAlignment(Qt::AlignRight);
    label->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(label, 0, static_cast<int>(heads_.size()));
    heads_.push_back(label);
  }
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      auto* label = new QLabel(this);
      const bool is_number = column > 0 && column < kColumns - 1;
      label->setAlignment(is_number ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
      layout->addWidget(label, row + 1, column);
      cells_.push_back(label);
    }
  }
  for (int column = 1; column < kColumns - 1; ++column) layout->setColumnStretch(column, 1);
}

void LoopValues::show_loop(const ControlLoopInfo& loop, const LoopReading& reading) {
  const struct {
    QString name;
    QString help;
    const std::vector<double>& values;
    const QString& unit;
    bool exists;
  } rows[kRows] = {
      {tr("Set point"), tr("What the loop is to keep"), reading.set_point, reading.unit, !loop.set_point.empty()},
      {tr("Actual"), tr("What it really is, also where sensors are in error"), reading.actual, reading.unit,
       !loop.actual.empty()},
      {tr("Error"), tr("By how much the actual value is off"), reading.error, reading.unit, !loop.actual.empty()},
      {tr("Commanded"), tr("Force or torque that this loop asks for"), reading.commanded, reading.effort_unit,
       !loop.commanded.empty()},
      {tr("Delivered"), tr("Force or torque that the actuators exert, for all loops that ask for it"),
       reading.delivered, reading.effort_unit, !loop.delivered.empty()},
      {tr("Disturbance"), tr("What the observer takes the disturbance to be"), reading.disturbance, reading.effort_unit,
       !loop.disturbance.empty()}};
  bool has_vectors = false;
  for (int row = 0; row < kRows; ++row) {
    const auto& line = rows[row];
    QLabel** cells = &cells_[static_cast<std::size_t>(row * kColumns)];
    double largest = 0;
    for (const double value : line.values) largest = std::max(largest, std::abs(value));
    for (int column = 0; column < kColumns; ++column) cells[column]->setVisible(line.exists);
    cells[0]->setText(line.name);
    cells[0]->setToolTip(line.help);
    for (int i = 0; i < kColumns - 2; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const bool known = index < line.values.size();
      cells[1 + i]->setText(known ? short_number(line.values[index], largest) : i == 0 ? QStringLiteral("–") : "");
    }
    cells[kColumns - 1]->setText(line.unit);
    has_vectors = has_vectors || line.values.size() > 1;
  }
  for (int i = 1; i < kColumns - 1; ++i) heads_[static_cast<std::size_t>(i)]->setVisible(has_vectors);
}

QString LoopValues::row_text(int row) const {
  QStringList texts;
  for (int column = 0; column < kColumns; ++column) {
    const QString text = cells_[static_cast<std::size_t>(row * kColumns + column)]->text();
    if (!text.isEmpty()) texts << text;
  }
  return texts.join(' ');
}

}  // namespace netpocket
