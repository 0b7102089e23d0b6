#pragma once
// What a picked thing is and how it is doing, in words for people.

#include <QString>
#include <vector>

#include "gui/workbench/viewport/picker.h"

namespace netpocket {

struct PickRow {
  QString label;
  QString value;  // with unit
};

struct PickDescription {
  QString title;   // "rod 3", "panel 2 row 4", "target"
  QString detail;  // what kind of thing
  std::vector<PickRow> rows;
};

PickDescription describe_pick(const Pick& pick, const Structure& structure, const Snapshot& snapshot);

}  // namespace netpocket
