#pragma once
// The numbers a run is judged by, computed from its channels.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/analysis/verdict.h"

namespace netpocket {

class Recording;

struct RunSummary {
  Verdict captured = Verdict::unknown;       // the target is inside the closed pocket at the end, and never left it
  std::optional<double> first_contact_time;  // s
  Eigen::Vector3d peak_force{0, 0, 0};       // N, largest |component| of the contact force on the target, with its sign
  double peak_time_y = 0;                    // s, when |F_y| peaks
  Eigen::Vector3d impulse{0, 0, 0};          // N s, integral of the contact force on the target
  double energy_error = 0;                   // largest |energy_error| / energy put in
  double energy_error_joules = 0;            // J, largest |energy_error|
  double energy_put_in = 0;                  // J, with the kinetic energy at the start
  double averaging_window = 0;               // s, over which the recorded forces are means
};

RunSummary summarize(const Recording& recording);

// With less put in (J), as in the first moments of a run, an error of round-off's size would be many per cent.
inline constexpr double kLeastComparableEnergy = 1;

// "0.012 J, 0.34 % of the energy put in", or that this is too little to compare with.
std::string energy_error_text(double joules, double put_in);

// A number behind a verdict: what an ensemble of runs tells the spread of.
struct Measure {
  std::string name;
  std::string unit;
  double value = 0;
};

struct FindingCase {
  std::string name;   // scenario name
  std::string value;  // what was found, with unit
  Verdict verdict = Verdict::unknown;
  std::vector<Measure> measures{};

  bool holds() const { return verdict == Verdict::yes; }
};

struct Finding {
  std::string id;    // "F1"
  std::string text;  // the paper's statement
  std::string rule;  // how it is decided from the recording
  std::vector<FindingCase> cases;
};

// F1-F11 of the paper (Tang et al. 2023, section 4.2 and conclusions) for these runs, by the rules stated in each.
// Findings that compare runs (F3, F4, F5) hold or fail for all runs together. All findings of a run that diverged say
// so.
std::vector<Finding> evaluate_findings(const std::vector<const Recording*>& recordings);

}  // namespace netpocket
