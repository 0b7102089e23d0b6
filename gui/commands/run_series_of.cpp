#include "gui/commands/run_series_of.h"

#include "gui/commands/recordings.h"

namespace netpocket {

std::vector<RunSeries> run_series_of(const std::vector<std::string>& paths) {
  const std::vector<Recording> recordings = open_recordings(paths);
  return run_series(pointers(recordings));
}

}  // namespace netpocket
