#pragma once
// Runs a study: all variants of all points, several at the same time.

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/study/study.h"
#include "engine/study/study_record.h"

namespace netpocket {

struct StudyOptions {
  int jobs = 1;              // number of runs at the same time, each on its own thread
  bool resume = false;       // keep points already in the folder, if nothing they depend on has changed
  std::string version = {};  // program version, for recordings and records
  std::string commit = {};
  std::string command = {};
};

struct StudyProgress {
  std::size_t points = 0;       // includes points kept from before and refused points
  std::size_t points_done = 0;  // of these
  double fraction = 0;          // of the simulated time that this call has to run
  double wall_seconds = 0;
};

struct StudyOutcome {
  std::vector<StudyRecord> records;  // of the finished points, in their order
  std::size_t points = 0;
  bool stopped = false;
};

// Called after each frame from the threads of the runs, by one thread at a time.
using StudyCallback = std::function<void(const StudyProgress&)>;

// Writes into `folder`, which must be new, empty or of this study (study_folder.h):
// - points/NNNN.json when a point is finished,
// - runs/NNNN_VARIANT.h5 during the run, kept if the study says so,
// - study.csv and study.json of the finished points at the end, also when stopped.
// The results of the runs do not depend on `jobs`. Points whose scenario is not valid are not run; their record says
// why. Throws FileError when something cannot be written; finished points remain.
StudyOutcome run_study(const Study& study, const std::string& folder, const StudyOptions& options,
                       const StudyCallback& progress = {}, const std::stop_token& stop = {});

}  // namespace netpocket
