#pragma once
// A small table of one loop's quantities: components and size.

#include <QWidget>
#include <vector>

#include "gui/workbench/control/loop_reading.h"

class QGridLayout;
class QLabel;

namespace netpocket {

class LoopValues : public QWidget {
  Q_OBJECT
 public:
  explicit LoopValues(QWidget* parent = nullptr);

  void show_loop(const ControlLoopInfo& loop, const LoopReading& reading);
  // Text of a row: "Error" and its numbers, separated by spaces. For tests.
  QString row_text(int row) const;

 private:
  static constexpr int kRows = 6, kColumns = 5;  // name, x, y, z, unit; a scalar or a size stands in x

  std::vector<QLabel*> cells_;
  std::vector<QLabel*> heads_;
};

}  // namespace netpocket
