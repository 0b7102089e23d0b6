#pragma once
// Runs points as a search asks for them, several at the same time, and keeps their records. A search that is asked
// again asks for the same points in the same order: what the folder already holds of them is not run again, so that an
// interrupted search goes on where it was. Thread contract: one thread at a time per object.

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/study/found_records.h"
#include "engine/study/record_files.h"
#include "engine/study/run_study.h"

namespace netpocket {

// Thrown by PointRunner::run() when it was asked to stop.
struct SearchStopped {};

class PointRunner {
 public:
  // The study has one variant and neither judges findings nor keeps recordings. `points`: how many the search will ask
  // for, at most; for the progress. All arguments must outlive the object.
  PointRunner(const Study& study, const std::string& folder, const StudyOptions& options, std::size_t points,
              const StudyCallback& progress, const std::stop_token& stop);
  ~PointRunner();
  PointRunner(const PointRunner&) = delete;
  PointRunner& operator=(const PointRunner&) = delete;

  // Records of the points, in their order. The points are numbered in the order in which they are asked for. Throws
  // FileError, and SearchStopped.
  std::vector<StudyRecord> run(const std::vector<StudyPoint>& points);

  // Of all points that were asked for and are finished, in their order.
  std::vector<RecordPlace> places() const;
  std::size_t runs_made() const;
  double wall_seconds() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netpocket
