#pragma once
// Evaluates the draws of a study's ensemble: F3, which single runs cannot decide, and the spread of all other findings.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

class Ensemble {
 public:
  // Keeps the records of draws that ran to their end in all variants. The number of other draws is reported.
  explicit Ensemble(const std::vector<StudyRecord>& records);

  std::size_t size() const { return draws_.size(); }
  // Sets F3 of a record with the same variants to the draws' verdict, with the values behind it.
  void decide(StudyRecord& record) const;
  // Number of draws in which a finding holds in all cases, as the text of a table's cell.
  std::string count_text(const std::string& id) const;
  // Markdown: number of draws in which the finding holds; median, least and largest of the numbers behind it. Empty
  // without draws.
  std::string section(const std::string& id) const;

 private:
  std::vector<StudyRecord> draws_;
  std::size_t lost_ = 0;  // number of draws that were refused or not run to their end
};

}  // namespace netpocket
