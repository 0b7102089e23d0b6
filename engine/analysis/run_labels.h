#pragma once
// Labels of runs that are shown together.

#include <string>
#include <vector>

namespace netpocket {

class Recording;

// Scenario names. Runs of the same name are told apart by the settings in which they differ, such as "case1,
// target.radius = 4.2". If they differ in no setting, or in too many to read, the file names tell them apart.
std::vector<std::string> run_labels(const std::vector<const Recording*>& recordings);

// A setting of a recorded scenario, whose text has one per line. Key such as "target.radius"; value as written.
struct RecordedSetting {
  std::string key;
  std::string value;
  bool operator==(const RecordedSetting&) const = default;
};
std::vector<RecordedSetting> recorded_settings(const std::string& scenario_text);

}  // namespace netpocket
