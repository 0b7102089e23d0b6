#pragma once
// What the draws of a study's ensemble say: F3, which single runs do not decide, and the spread of all other findings.

#include <string>
#include <vector>

#include "engine/study/study_record.h"

namespace netpocket {

class Ensemble {
 public:
  // Keeps the records with a draw that was run to its end in all variants; the number of the others is told.
  explicit Ensemble(const std::vector<StudyRecord>& records);

  std::size_t size() const { return draws_.size(); }
  // Gives F3 of a record with the same variants the verdict of the draws, with the values behind it.
  void decide(StudyRecord& record) const;
  // In how many draws a finding holds in all cases, for a cell of a table.
  std::string count_text(const std::string& id) const;
  // Markdown: in how many draws it holds, and median, least and largest of the numbers behind it. Empty without draws.
  std::string section(const std::string& id) const;

 private:
  std::vector<StudyRecord> draws_;
  std::size_t lost_ = 0;  // refused or diverged
};

}  // namespace netpocket
