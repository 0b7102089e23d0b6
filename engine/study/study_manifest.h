#pragma once
// The file, in a study's folder, that says what the study consists of: enough to tell how far it is, and to make the
// scenario of any of its points again without the study's own file.
// Thread contract: any thread may call these functions. Errors: FileError.

#include <optional>
#include <string>
#include <vector>

#include "engine/study/study.h"
#include "engine/study/study_record.h"

namespace netpocket {

// Name of the file, in the study's folder.
inline constexpr char kStudyManifest[] = "study_manifest.json";

struct StudyManifest {
  std::string study;                   // its name
  std::string file;                    // absolute path of its file
  std::size_t points = 0;              // that it takes, at most
  std::vector<std::string> uncertain;  // used_keys()
  std::string program;                 // that wrote the manifest
  std::vector<NamedSettings> variants;
  std::string objective;         // objective_name() of a study that optimises, else empty
  std::string failure;           // failure_name() of a study of a rare failure, else empty
  std::optional<Scenario> base;  // nothing: an earlier version wrote the manifest
};

// `points`: how many the study takes, at most. `program`: version and commit.
void write_study_manifest(const Study& study, std::size_t points, const std::string& folder,
                          const std::string& program);

StudyManifest read_study_manifest(const std::string& folder);

// The scenario of a run of a record, `run` counted from 0. The diagnostics say why it cannot be made.
StudyScenario recorded_scenario(const StudyManifest& manifest, const StudyRecord& record, std::size_t run);

// Whether a program runs exactly what a record says was run: its version, the scenarios and their meshes are the same.
bool is_as_recorded(const StudyManifest& manifest, const StudyRecord& record, const std::string& program);

}  // namespace netpocket
