#include "render/figures/run_series.h"

#include "engine/recording/recording.h"
#include "engine/recording/run_labels.h"

namespace netpocket {

RunSeries run_series(const Recording& recording) {
  RunSeries series;
  series.name = recording.origin().scenario_name;
  for (std::size_t i = 0; i < kChannelCount; ++i) series.channels[i] = recording.channel(static_cast<Channel>(i));
  series.closing_end = recording.origin().closing_end;
  series.towing_start = recording.origin().towing_start;
  return series;
}

std::vector<RunSeries> run_series(const std::vector<const Recording*>& recordings) {
  std::vector<RunSeries> runs;
  for (const Recording* recording : recordings) runs.push_back(run_series(*recording));
  const auto labels = run_labels(recordings);
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].name = labels[i];
  return runs;
}

}  // namespace netpocket
