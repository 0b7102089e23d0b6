#pragma once
// The numbers by which a run is judged, computed from its channels.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/analysis/verdict.h"

namespace netpocket {

class Recording;
class RunData;

struct RunSummary {
  Verdict captured = Verdict::unknown;       // yes: the target is inside the closed pocket at the end and never left it
  std::optional<double> first_contact_time;  // s
  Eigen::Vector3d peak_force{0, 0, 0};       // N, by component: force on the target of largest size, with its sign
  double peak_time_y = 0;                    // s, time of the largest |F_y|
  Eigen::Vector3d impulse{0, 0, 0};          // N s, integral of the contact force on the target
  double energy_error = 0;                   // largest |energy_error| as a fraction of the energy put in
  double energy_error_joules = 0;            // J, largest |energy_error|
  double energy_put_in = 0;                  // J, includes the kinetic energy at the start
  double averaging_window = 0;               // s, length of the intervals over which recorded forces are means
};

RunSummary summarize(const RunData& data);

// Energy put in (J) below which no relative error is stated, as in the first moments of a run: rounding errors alone
// would be many per cent.
inline constexpr double kLeastComparableEnergy = 1;

// "0.012 J, 0.34 % of the energy put in", or a remark that this energy is too small to compare with.
std::string energy_error_text(double joules, double put_in);

// A number behind a verdict. An ensemble of runs shows its spread.
struct Measure {
  std::string name;
  std::string unit;
  double value = 0;
};

struct FindingCase {
  std::string name;   // scenario name
  std::string value;  // value found, with unit
  Verdict verdict = Verdict::unknown;
  std::vector<Measure> measures{};

  bool holds() const { return verdict == Verdict::yes; }
};

struct Finding {
  std::string id;    // "F1"
  std::string text;  // the paper's statement
  std::string rule;  // how it is judged from the recording
  std::vector<FindingCase> cases;
};

// F1-F11 of the paper (Tang et al. 2023, section 4.2 and conclusions) for these runs, by the rules stated in each.
// Findings that compare runs (F3, F4, F5) hold or fail for all runs together. A run that diverged has that verdict in
// all findings.
std::vector<Finding> evaluate_findings(const std::vector<const Recording*>& recordings);

}  // namespace netpocket
