#pragma once
// Runs a study: all variants of all points, several at the same time.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/study/estimate.h"
#include "engine/study/optimisation.h"
#include "engine/study/rare_failure.h"
#include "engine/study/sensitivity_estimate.h"
#include "engine/study/study.h"
#include "engine/study/study_record.h"

namespace netpocket {

// Points i with i mod parts == part - 1, counted from 0.
struct StudyPart {
  int part = 1;
  int parts = 1;
};

struct StudyOptions {
  int jobs = 1;              // number of runs at the same time, each on its own thread; 0: only puts tables together
  bool resume = false;       // keep points already in the folder, if nothing they depend on has changed
  std::string version = {};  // program version, for recordings and records
  std::string commit = {};
  std::string command = {};
  StudyPart part = {};  // other parts may run at the same time, in the same folder
};

struct StudyProgress {
  std::size_t points = 0;       // of this part; includes points kept from before and refused points
  std::size_t points_done = 0;  // of these
  double fraction = 0;          // of the runs that this call has to make
  double wall_seconds = 0;
};

struct StudyOutcome {
  std::vector<StudyRecord> records;      // of the finished points, in their order; only of studies with findings
  std::size_t points = 0;                // of the study, or as many as it took until its interval was narrow enough
  std::size_t points_done = 0;           // of these, by all parts
  std::size_t refused = 0;               // of these; of this part's only, while points of others are missing
  std::size_t diverged = 0;              // likewise, points with a run that diverged
  std::size_t limited = 0;               // likewise, with one that reached its limit of steps
  std::string first_refusal;             // why the first refused point was refused
  bool stopped = false;                  // points of this part are missing
  bool has_tables = false;               // the tables were written
  std::vector<GroupEstimate> estimates;  // of studies with uncertain inputs, whose points are a sample
  std::vector<SensitivityEstimate> sensitivities;  // of studies with [sensitivity]
  std::optional<Optimisation> optimisation;        // of studies with [optimise] that came to their end
  std::optional<RareFailure> rare_failure;         // likewise with [rare]
  std::size_t runs_made = 0;                       // by this call
  double wall_seconds = 0;                         // of this call
};

// Called after each frame from the threads of the runs, by one thread at a time.
using StudyCallback = std::function<void(const StudyProgress&)>;

// Writes into `folder`, which must be new, empty or of this study (study_folder.h):
// - records/PART.jsonl, a line when a point is finished (record_files.h),
// - runs/NNNN_VARIANT.h5 during the run, if the study judges findings; kept if the study says so,
// - the tables of the finished points (study_table.h) at the end, also when stopped; of a study in parts when no point
//   of any part is missing. Whichever part is last writes them.
// - study_estimates.csv of studies with uncertain inputs and study_sensitivity.csv of those with [sensitivity], with
//   the tables,
// - what run_search.h says, if the study searches.
// The results do not depend on `jobs` or parts. Points whose scenario is not valid are not run; their record says why.
// Throws FileError when something cannot be written; finished points remain.
StudyOutcome run_study(const Study& study, const std::string& folder, const StudyOptions& options,
                       const StudyCallback& progress = {}, const std::stop_token& stop = {});

}  // namespace netpocket
