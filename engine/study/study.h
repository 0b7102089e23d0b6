#pragma once
// A study: many runs that differ from a base scenario in stated ways. Each point is a set of settings. Every variant
// (such as three closing times) is run at each point. Findings that compare runs compare the variants of a point.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"
#include "engine/study/setting.h"

namespace netpocket {

// A parameter that varies between points, over a list of values or a range of numbers.
struct Axis {
  std::string key{};
  std::vector<std::string> values{};  // in TOML syntax; empty for a range
  double from = 0;
  double to = 0;
  int steps = 0;             // number of values that a grid takes from a range, both ends included
  bool logarithmic = false;  // equal ratios between steps instead of equal differences
  bool whole = false;        // whole numbers only
};

struct NamedSettings {
  std::string name;
  std::vector<Setting> settings;
};

enum class Sampling {
  grid,    // every combination
  halton,  // points spread evenly over all axes: Halton, Numer. Math. 2 (1960) 84
};

// Draws of the first point: its runs repeated with random initial displacements of every free node of up to
// `perturbation` (m), with seeds 1 to `runs`. They show what depends on rounding errors.
struct StudyEnsemble {
  int runs = 0;
  double perturbation = 1e-6;
};

// The document that --report writes.
struct StudyReport {
  bool of_search = false;         // true: the best of many points; false: findings of the first point
  int best = 0;                   // search: number of points in the table; 0: all
  std::vector<std::string> show;  // search: findings whose values the table shows
};

struct Study {
  std::string name;
  std::string file;  // name of the study's file without folder and extension
  std::string description;
  Scenario base;
  std::vector<Setting> settings;        // for all points
  std::vector<NamedSettings> places;    // sets of settings about which the axes vary; at least one
  std::vector<Axis> axes;               // in the order of the file
  std::vector<NamedSettings> variants;  // run at each point; at least one
  Sampling sampling = Sampling::grid;
  int samples = 0;        // halton: number of points for each place
  std::int64_t seed = 1;  // halton: seed of the random shift
  bool keep_recordings = false;
  StudyEnsemble ensemble;
  StudyReport report;
  std::map<std::string, std::string> remarks;  // by finding ("F5"), shown in the report
};

struct StudyPoint {
  std::string place;              // name of its place; empty when the study has only one
  std::vector<Setting> settings;  // all settings on the base except those of variants; later ones override earlier ones
  int draw = 0;                   // 1, 2, ...: number of the draw; 0: not of the ensemble
};

// All points, in an order that depends only on the study. Draws of the ensemble come last.
std::vector<StudyPoint> study_points(const Study& study);

// The scenario of one variant of a point. The diagnostics say why it cannot run (check_scenario).
struct StudyScenario {
  Scenario scenario;
  Diagnostics diagnostics;
};
StudyScenario study_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant);

}  // namespace netpocket
