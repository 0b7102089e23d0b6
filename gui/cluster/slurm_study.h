#pragma once
// A study as a job array of Slurm. Each task runs one part (netpocket study --part i/K) into the study's folder; a job
// that depends on the array puts the tables together. DIR/slurm.json remembers the jobs, DIR/slurm has scripts and
// logs. Thread contract: one thread at a time per folder.

#include <string>
#include <vector>

#include "engine/study/study.h"
#include "engine/study/study_status.h"

namespace netpocket {

struct SlurmChoice {
  std::string study;            // file
  std::string folder;           // of the study
  std::string report;           // file that the collecting job writes; empty: none
  int parts = 0;                // 0: as before or, of a new study, about twenty points each, at most 1000
  std::string partition, time;  // as sbatch takes them; empty: as the cluster has them
  std::string program;          // file of the program that runs the parts
  std::string version;          // what records name as their program
};

struct SlurmSubmission {
  int parts = 0;                 // of the study
  std::vector<int> submitted;    // of these
  int alive = 0;                 // of these, with missing points, still in the queue from before
  std::size_t missing = 0;       // points
  std::string array, collector;  // jobs; empty if nothing was submitted
};

// Submits the parts with missing points, except those that are still in the queue, and remembers them. Throws
// SlurmError, and FileError and RecordingError of the folder.
SlurmSubmission submit_study(const Study& study, const SlurmChoice& choice);

// Some lines for people: how many parts are done, running, waiting and failed, and why. Empty when the folder's study
// was not submitted. Throws FileError when slurm.json is damaged.
std::string slurm_status_text(const std::string& folder, const StudyStatus& status);

}  // namespace netpocket
