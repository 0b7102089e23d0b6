#include "gui/commands/recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

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

void require_fewer_pictures(const std::vector<const Recording*>& recordings, double rate) {
  constexpr double kMost = 1e5;
  double start = std::numeric_limits<double>::infinity(), end = -start;
  for (const Recording* recording : recordings) {
    if (recording->frame_count() == 0) continue;
    start = std::min(start, recording->times().front());
    end = std::max(end, recording->times().back());
  }
  if (!((end - start) * rate > kMost)) return;
  throw CommandError(
      ExitCode::usage,
      fmt::format("--fps: {:g} pictures a second of {:g} s would be {:.3g} pictures; at most {:g} are drawn", rate,
                  end - start, (end - start) * rate, kMost));
}

}  // namespace netpocket
