#pragma once
// What runs are called where several stand next to each other.

#include <string>
#include <vector>

namespace netpocket {

class Recording;

// The scenarios' names. Runs that share one are told apart by the settings in which they differ, as in
// "case1, target.radius = 4.2"; where these are none or too many to be read, by their files.
std::vector<std::string> run_labels(const std::vector<const Recording*>& recordings);

// The settings of a scenario as it is recorded: one in a line. Keys such as "target.radius", values as written.
struct RecordedSetting {
  std::string key;
  std::string value;
  bool operator==(const RecordedSetting&) const = default;
};
std::vector<RecordedSetting> recorded_settings(const std::string& scenario_text);

}  // namespace netpocket
