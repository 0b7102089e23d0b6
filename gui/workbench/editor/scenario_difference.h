#pragma once
// In which parameters two scenarios differ, in words for a table.

#include <QString>
#include <vector>

#include "engine/scenario/parameters.h"

namespace netpocket {

struct ScenarioDifference {
  const Parameter* parameter = nullptr;  // of both; null: of a list's length, or of all when the systems differ
  QString key;                           // in the file
  QString name;                          // "Closing: duration"
  QString here;                          // without the unit
  QString there;
  QString unit;
};

// In the order of the parameters. Two systems have no parameters in common: then there is one row, that says so.
std::vector<ScenarioDifference> differences(const Scenario& here, const Scenario& there);

}  // namespace netpocket
