#pragma once
// The results of a study as they come in, point by point and in any order. Thread contract: one thread at a time per
// object.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/study/record_follower.h"
#include "engine/study/study_manifest.h"
#include "engine/study/study_results.h"

namespace netpocket {

class LiveResults {
 public:
  // The manifest says which columns are inputs; units are those of the base's parameters and of its metrics.
  explicit LiveResults(const StudyManifest& manifest);

  // A later record of a point takes the place of an earlier one.
  void add(const FollowedRecord& followed);

  // Rows of the runs that were added, in that order. Columns that come later are NaN in the earlier rows.
  const StudyResults& results() const { return results_; }
  // By row: where the record is, and which of its runs it is.
  struct Source {
    RecordPlace place;
    std::size_t run = 0;
  };
  const std::vector<Source>& sources() const { return sources_; }

  std::size_t finished() const { return rows_.size(); }  // points; includes the following two
  std::size_t refused() const { return refused_; }       // points whose scenario is not valid
  std::size_t diverged() const { return diverged_; }     // points with a run that diverged
  std::size_t limited() const { return limited_; }       // points with a run that reached its limit of steps
  const std::string& first_refusal() const { return first_refusal_; }
  std::int64_t captured() const { return captured_; }  // runs
  std::int64_t judged() const { return judged_; }      // runs: captured or not
  // Rows that are drafts, and what one of them says of itself (scenario/fidelity.h).
  std::size_t drafts() const { return drafts_; }
  const std::string& draft_notice() const { return draft_notice_; }

 private:
  using Places = std::map<std::string, std::size_t>;  // indices of columns by name
  struct Rows {
    std::size_t first = 0, count = 0;
  };

  void append_rows(std::size_t count);
  void write_row(std::size_t row, const StudyRecord& run, const Source& source);
  void put_setting(std::size_t row, const std::string& key, const std::string& value);
  void put(std::vector<ResultColumn>& columns, Places& places, std::size_t row, const std::string& name, double value);

  std::map<std::string, std::string> units_;
  std::vector<std::string> uncertain_;
  StudyResults results_;
  Places inputs_, measures_;
  std::map<std::string, double> shared_;  // numbers that all points so far have set, by key
  std::vector<Source> sources_;
  std::map<std::size_t, Rows> rows_;  // by point
  std::size_t refused_ = 0, diverged_ = 0, limited_ = 0;
  std::string first_refusal_;
  std::int64_t captured_ = 0, judged_ = 0;
  std::vector<char> is_draft_;  // by row
  std::size_t drafts_ = 0;
  std::string draft_notice_;
};

}  // namespace netpocket
