#pragma once
// Runs a study: all variants of all points, several side by side.

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/study/study.h"
#include "engine/study/study_record.h"

namespace netpocket {

struct StudyOptions {
  int jobs = 1;              // runs at a time, each on a thread of its own
  bool resume = false;       // keep the points that the folder holds already, as far as nothing they depend on changed
  std::string version = {};  // of the program, for recordings and records
  std::string commit = {};
  std::string command = {};
};

struct StudyProgress {
  std::size_t points = 0;       // with those kept from before and those refused
  std::size_t points_done = 0;  // likewise
  double fraction = 0;          // of the simulated time that this call has to run
  double wall_seconds = 0;
};

struct StudyOutcome {
  std::vector<StudyRecord> records;  // of the points that are done, in their order
  std::size_t points = 0;
  bool stopped = false;
};

// Called from the threads that run, one at a time, after each frame.
using StudyCallback = std::function<void(const StudyProgress&)>;

// Writes into `folder`, which must be new, empty or that study's own (see study_folder.h): points/NNNN.json as soon as
// a point is done, runs/NNNN_VARIANT.h5 while it runs (kept when the study says so), and at the end, also when stopped,
// study.csv and study.json of the points that are done. The runs themselves do not depend on `jobs`. Points whose
// scenario is not valid are not run; their record says why. Throws FileError when something cannot be written;
// what is done remains.
StudyOutcome run_study(const Study& study, const std::string& folder, const StudyOptions& options,
                       const StudyCallback& progress = {}, const std::stop_token& stop = {});

}  // namespace netpocket
