#pragma once
// A study: many runs that differ from a base scenario in stated ways. Each point is a set of settings; at each point
// every variant is run (the three closing times, say), and the findings that compare runs compare those.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"
#include "engine/study/setting.h"

namespace netpocket {

// A parameter that changes from point to point: a list of values, or a range of numbers.
struct Axis {
  std::string key{};
  std::vector<std::string> values{};  // as TOML writes them; empty for a range
  double from = 0;
  double to = 0;
  int steps = 0;             // values that a grid takes of a range, both ends included
  bool logarithmic = false;  // steps of equal ratio instead of equal difference
  bool whole = false;        // whole numbers only
};

struct NamedSettings {
  std::string name;
  std::vector<Setting> settings;
};

enum class Sampling {
  grid,    // every combination
  halton,  // points spread evenly over all axes at once: Halton, Numer. Math. 2 (1960) 84
};

// Draws of the first point: its runs again with every free node displaced at the start by up to `perturbation` m, at
// random with the seeds 1 to `runs`. They tell what depends on round-off.
struct StudyEnsemble {
  int runs = 0;
  double perturbation = 1e-6;
};

// What --report writes.
struct StudyReport {
  bool of_search = false;         // the best of many points; otherwise the findings of the first point
  int best = 0;                   // of a search: points in the table; 0: all
  std::vector<std::string> show;  // of a search: findings whose values stand in the table
};

struct Study {
  std::string name;
  std::string file;  // its name without folder and extension
  std::string description;
  Scenario base;
  std::vector<Setting> settings;        // of all points
  std::vector<NamedSettings> places;    // about each of which the axes vary; at least one
  std::vector<Axis> axes;               // by their order in the file
  std::vector<NamedSettings> variants;  // run at each point; at least one
  Sampling sampling = Sampling::grid;
  int samples = 0;        // halton: points for each place
  std::int64_t seed = 1;  // halton: of the shift
  bool keep_recordings = false;
  StudyEnsemble ensemble;
  StudyReport report;
  std::map<std::string, std::string> remarks;  // by finding ("F5"), for the report
};

struct StudyPoint {
  std::string place;              // name of the place it belongs to; empty when the study has only one
  std::vector<Setting> settings;  // all that differ from the base, variants excepted; a later one counts
  int draw = 0;                   // 1, 2, ...: of the ensemble
};

// All points, in an order that depends on the study only; those of the ensemble come last.
std::vector<StudyPoint> study_points(const Study& study);

// What one variant of a point runs; diagnostics say why it cannot (check_scenario).
struct StudyScenario {
  Scenario scenario;
  Diagnostics diagnostics;
};
StudyScenario study_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant);

}  // namespace netpocket
