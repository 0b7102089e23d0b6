#include "render/figures/run_series.h"

#include "engine/analysis/run_labels.h"
#include "engine/recording/recording.h"

namespace netpocket {

const std::vector<double>& RunSeries::channel(Channel c) const {
  static const std::vector<double> kNone;
  const auto index = channel_list->find(c);
  return index ? channels[*index] : kNone;
}

void RunSeries::begin(std::shared_ptr<const ChannelList> list) {
  channel_list = std::move(list);
  channels.assign(channel_list->size(), {});
}

void RunSeries::append(const std::vector<double>& values) {
  for (std::size_t i = 0; i < channels.size(); ++i) channels[i].push_back(values[i]);
  // Phases that begin with events are known once they have come.
  if (const auto phase = channel_list->find(kPhaseChannel)) phases = phases_of_channel(times(), channels[*phase]);
}

RunSeries run_series(const Recording& recording) {
  RunSeries series;
  series.name = recording.origin().scenario_name;
  series.channel_list = recording.channels();
  series.channels.clear();
  for (std::size_t i = 0; i < series.channel_list->size(); ++i) series.channels.push_back(recording.channel(i));
  series.phases = recording.origin().phases;
  series.loops = recording.structure().loops;
  series.draft = recording.origin().draft;
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
