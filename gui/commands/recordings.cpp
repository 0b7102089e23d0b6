#include "gui/commands/recordings.h"

#include "gui/commands/command.h"

namespace netpocket {

Recording open_recording(const std::string& path) {
  try {
    return Recording(path);
  } catch (const RecordingError& error) {
    throw CommandError(ExitCode::bad_input, error.what());
  }
}

std::vector<Recording> open_recordings(const std::vector<std::string>& paths) {
  std::vector<Recording> recordings;
  for (const std::string& path : paths) recordings.push_back(open_recording(path));
  return recordings;
}

std::vector<const Recording*> pointers(const std::vector<Recording>& recordings) {
  std::vector<const Recording*> result;
  for (const Recording& recording : recordings) result.push_back(&recording);
  return result;
}

}  // namespace netpocket
