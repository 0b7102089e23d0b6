#pragma once
// How far a study is, from its folder alone. Thread contract: any thread may call these functions. Errors: FileError.

#include <cstddef>
#include <string>
#include <vector>

namespace netpocket {

struct StudyFailure {
  std::size_t point = 0;  // 1, 2, ...
  std::string reason;
};

struct StudyStatus {
  std::string study;
  std::size_t points = 0;
  std::size_t finished = 0;            // of these; includes the following three
  std::size_t refused = 0;             // points whose scenario is not valid
  std::size_t diverged = 0;            // points with a run that diverged
  std::size_t limited = 0;             // points with a run that reached its limit of steps
  std::vector<bool> is_finished;       // by point
  std::vector<StudyFailure> failures;  // the first ones of all kinds, kMostFailuresListed at most
  std::vector<std::string> writing;    // files of records that programs on this machine are writing
};

inline constexpr std::size_t kMostFailuresListed = 20;

StudyStatus study_status(const std::string& folder);

// Some lines for people.
std::string status_text(const StudyStatus& status);

}  // namespace netpocket
