#pragma once
// The folder that a study writes into. It is the study's own: new or empty at first, and marked then with a file that
// says which study it belongs to. Nothing in it is removed that the study did not make itself.

#include <string>

namespace netpocket {

// Beside study.csv, study.json, points/ and runs/.
inline constexpr char kStudyMarker[] = "netpocket_study.json";

// Whether a study has begun in the folder.
bool holds_study(const std::string& folder);

// Holds the folder as long as it lives: no other program runs a study in it. Throws RecordingError with one sentence
// when the folder holds anything else, another study, or one that is running, or cannot be written.
class OwnedStudyFolder {
 public:
  // `name`: of the study.
  OwnedStudyFolder(const std::string& folder, const std::string& name);
  ~OwnedStudyFolder();
  OwnedStudyFolder(const OwnedStudyFolder&) = delete;
  OwnedStudyFolder& operator=(const OwnedStudyFolder&) = delete;

 private:
  void lock(const std::string& folder);
  void check_owner(const std::string& folder, const std::string& name) const;

  int marker_ = -1;  // open and locked
};

}  // namespace netpocket
