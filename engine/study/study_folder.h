#pragma once
// The folder into which a study writes. It must be new or empty at first, and is then marked with a file that names the
// study. Only files that the study itself made are removed from it.

#include <string>

namespace netpocket {

// Name of the marker file, in the same folder as study.csv, study.json, records/ and runs/.
inline constexpr char kStudyMarker[] = "netpocket_study.json";

// Whether the folder is marked by a study.
bool holds_study(const std::string& folder);

enum class FolderUse { alone, shared };

// Holds the folder for its lifetime: no other program can run a study in it, or none but those that share it with each
// other, as parts of one study do. Parts on several machines hold each other off only as far as the file system knows
// locks; a part writes files of its own. Throws RecordingError with one sentence
// when the folder cannot be written, holds anything else or another study, or when its study is running.
class OwnedStudyFolder {
 public:
  // `name`: name of the study.
  OwnedStudyFolder(const std::string& folder, const std::string& name, FolderUse use = FolderUse::alone);
  ~OwnedStudyFolder();
  OwnedStudyFolder(const OwnedStudyFolder&) = delete;
  OwnedStudyFolder& operator=(const OwnedStudyFolder&) = delete;

 private:
  void lock(const std::string& folder, FolderUse use);
  void check_owner(const std::string& folder, const std::string& name) const;

  int marker_ = -1;  // descriptor of the marker file, locked
};

}  // namespace netpocket
