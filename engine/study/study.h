#pragma once
// A study: many runs that differ from a base scenario in stated ways. Each point is a set of settings. Every variant
// (such as three closing times) is run at each point. Findings that compare runs compare the variants of a point.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/diagnostics.h"
#include "engine/scenario/scenario.h"
#include "engine/study/setting.h"
#include "engine/study/uncertain_input.h"

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

// Of the uncertain inputs if there are any, and the axes are then a grid; else of the axes.
enum class Sampling {
  grid,    // every combination
  halton,  // this and the following: designs of sampling/design.h
  monte_carlo,
  latin_hypercube,
  sobol,
};

// What a campaign estimates from its captures.
struct StudyEstimate {
  double confidence = 0.95;
  std::vector<double> quantiles = {0.05, 0.5, 0.95};
  std::vector<std::string> of;  // columns of the table whose quantiles are estimated
};

enum class SensitivityMethod { none, sobol, morris };

// Which inputs decide a column of the table. The points are then those of the method, not a sample.
struct StudySensitivity {
  SensitivityMethod method = SensitivityMethod::none;
  std::string of = "captured";
  int size = 0;    // blocks of the Sobol indices, trajectories of the screening
  int levels = 4;  // of the screening

  // Number of points for a number of coordinates.
  double point_count(int coordinates) const {
    return static_cast<double>(size) * (coordinates + (method == SensitivityMethod::sobol ? 2 : 1));
  }
};

// When a campaign ends early: the interval of the probability of capture of every variant is no wider than asked for,
// looked at after each batch of points.
struct StudyStop {
  double half_width = 0;  // 0: never
  int batch = 100;        // points
};

// What a column of the table is over the draws of the uncertain inputs: its mean or, with `fraction` set, the value
// below which that share of the draws lies (0: the least, 1: the largest). Draws without a number are left out.
struct ColumnOverDraws {
  std::string column;
  std::optional<double> fraction{};
};

struct StudyConstraint {
  ColumnOverDraws value;
  std::optional<double> at_most{}, at_least{};
};

// A search by CMA-ES (statistics/evolution_strategy.h) for the values of parameters at which a column is least or
// largest, within constraints. Each set of values, a candidate, runs with the same draws of the uncertain inputs.
struct StudyOptimisation {
  std::vector<Axis> over;  // ranges; a candidate has a value of each
  ColumnOverDraws objective;
  bool is_maximised = false;
  std::vector<StudyConstraint> constraints;
  int candidates = 0;  // no new generation begins beyond it; 0: the study does not search
  int population = 0;  // of the first run; 0: 4 + floor(3 ln n)
  int restarts = 3;
  double step = 0.3;         // first standard deviation, as a fraction of the ranges
  double least_step = 1e-3;  // at which a run has converged, likewise
  int check = 200;           // fresh draws with which the base and the best candidate are run in the end
};

// The probability of a rare failure by subset simulation (statistics/subset_simulation.h): of a number in a column of
// the table that is at most, or at least, `limit`.
struct StudyRareFailure {
  std::string of;  // empty: the study does not look for one
  double limit = 0;
  bool is_above = false;  // fails at `limit` and above, else at `limit` and below
  int samples = 500;      // per level
  int levels = 6;         // at most
};

// Draws of the first point: its runs repeated with random initial displacements of every free node of up to
// `perturbation` (m), with seeds 1 to `runs`. They show what depends on rounding errors.
struct StudyEnsemble {
  int runs = 0;
  double perturbation = 1e-6;
};

// What the document that --report writes is about: the findings of the first point, the best of many points, or the
// study's own statements.
enum class ReportOf { findings, search, statements };

struct StudyReport {
  ReportOf of = ReportOf::findings;
  int best = 0;                   // search: number of points in the table; 0: all
  std::vector<std::string> show;  // search: findings whose values the table shows; statements: columns of the table
};

// A statement about a column of the table: at every point, the number of a variant, or what it is of that of another
// variant, lies within limits.
struct StudyStatement {
  std::string text;
  std::string column;
  std::string variant;
  std::string against;  // variant by which the number is divided; empty: none
  std::optional<double> at_most{}, at_least{};
};

struct Study {
  std::string name;
  std::string path;  // of its file, as it was named
  std::string file;  // name of the study's file without folder and extension
  std::string description;
  Scenario base;
  std::vector<Setting> settings;        // for all points
  std::vector<NamedSettings> places;    // sets of settings about which the axes vary; at least one
  std::vector<Axis> axes;               // in the order of the file
  std::vector<NamedSettings> variants;  // run at each point; at least one
  Sampling sampling = Sampling::grid;
  int samples = 0;        // not of grids: number of points for each place or, of uncertain inputs, for each combination
  std::int64_t seed = 1;  // not of grids
  std::vector<UncertainInput> uncertain;  // in the order of the file
  bool keep_recordings = false;
  bool has_findings = true;  // whether findings are judged, which takes a recording of each run while it is judged
  StudyEstimate estimate;
  StudyStop until;
  StudySensitivity sensitivity;
  StudyOptimisation optimisation;
  StudyRareFailure rare;
  StudyEnsemble ensemble;
  StudyReport report;
  std::vector<StudyStatement> statements;      // in the order of the file
  std::map<std::string, std::string> remarks;  // by finding ("F5") or statement ("S1"), shown in the report

  // Whether the results of points decide which points follow (run_search.h).
  bool is_search() const { return optimisation.candidates > 0 || !rare.of.empty(); }
};

struct StudyPoint {
  std::string place;              // name of its place; empty when the study has only one
  std::vector<Setting> settings;  // all settings on the base except those of variants; later ones override earlier ones
  int draw = 0;                   // 1, 2, ...: number of the draw; 0: not of the ensemble
};

// All points at once (study_plan.h).
std::vector<StudyPoint> study_points(const Study& study);

// The scenario of one variant of a point. The diagnostics say why it cannot run (check_scenario).
struct StudyScenario {
  Scenario scenario;
  Diagnostics diagnostics;
};
StudyScenario study_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant);
// The same without check_scenario, which takes much longer.
StudyScenario unchecked_scenario(const Study& study, const StudyPoint& point, const NamedSettings& variant);

}  // namespace netpocket
