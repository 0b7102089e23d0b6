#pragma once
// Reads studies from TOML (scenarios/studies/README.md describes the file). Errors are returned as values with file,
// line and key; nothing is thrown. Thread contract: any thread may call these functions.

#include <string>

#include "engine/study/study.h"

namespace netpocket {

inline constexpr std::size_t kMostSampledAxes = 12;  // Halton sequences of larger primes are uneven
inline constexpr std::size_t kMostStudyPoints = 100000;
inline constexpr std::size_t kLargestStudyFile = 1'000'000;  // bytes

struct StudyResult {
  Study study{};              // complete only if ok()
  Diagnostics diagnostics{};  // sorted by line

  bool ok() const { return diagnostics.ok(); }
};

// The base scenario's path is relative to the study's file. Each key and value is checked by itself. Whether a point
// makes sense as a whole is checked when it is run.
StudyResult read_study_file(const std::string& path);

}  // namespace netpocket
