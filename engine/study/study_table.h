#pragma once
// Tables of a study's points: a header line of names and one row per run, or one per refused point. They depend only on
// the study and the program, and are written row by row.

#include <map>
#include <string>
#include <vector>

#include "engine/study/record_files.h"
#include "engine/study/study_record.h"

namespace netpocket {

struct TableColumn {
  std::string name;
  std::string unit;     // empty for texts, "1" for pure numbers
  std::string meaning;  // half a line
};

// Columns: point, place, draw, the settings that differ between points, the uncertain values that the run used,
// variant, why the point was refused, how the run ended, the numbers of its summary, its metrics, and for each finding
// the verdict and the value.
class StudyTable {
 public:
  // `metrics`: names of all metrics, `findings`: ids. The study must outlive the table.
  StudyTable(const Study& study, std::vector<std::string> metrics, std::vector<std::string> findings);

  const std::vector<TableColumn>& columns() const { return columns_; }
  std::string header() const;
  // The rows of a point, a line each. Follows RFC 4180, except that line ends in a text are escaped as in TOML.
  std::string rows(const StudyRecord& record) const;

 private:
  std::vector<std::string> first_cells(const StudyRecord& record) const;
  std::vector<std::string> row(const StudyRecord& record, std::size_t run) const;

  std::vector<std::string> settings_, used_, metrics_, findings_;
  std::vector<TableColumn> columns_;
};

// The number that a column has for a run of a record: of its summary ("captured": 1 or 0), metrics or used values. NaN
// where there is none.
double run_number(const StudyRecord& run, const std::string& column);

// All rows at once, for few records.
std::string study_csv(const Study& study, const std::vector<StudyRecord>& records);

// Writes into the folder, whole or not at all:
// - study.csv, the table
// - study_columns.csv: name, unit and meaning of its columns
// - study_timings.csv: point, variant, wall_s and cpu_s of each run, which differ from time to time
// - study.json: {"study", "description", "rules" {finding: rule}, "points" [records without timings]}
// `places`: of the records, in the order of their points.
void write_study_tables(const Study& study, const std::string& folder, const std::vector<RecordPlace>& places);

}  // namespace netpocket
