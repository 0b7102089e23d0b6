#include "engine/analysis/csv.h"

#include <fmt/format.h>

#include <vector>

#include "engine/base/whole_file.h"
#include "engine/recording/recording.h"
#include "engine/state/written_time.h"

namespace netpocket {

namespace {

std::string header(const ChannelList& channels) {
  std::vector<std::string_view> names;
  names.reserve(channels.size());
  for (const ChannelInfo& channel : channels) names.push_back(channel.name);
  return fmt::format("{}\n", fmt::join(names, ","));
}

std::string row(const Recording& recording, std::size_t frame) {
  fmt::memory_buffer line;
  const auto time = recording.channels()->find(Channel::time);
  for (std::size_t c = 0; c < recording.channels()->size(); ++c) {
    const double recorded = recording.channel(c)[frame];
    const double value = c == time ? written_time(recorded) : recorded;
    fmt::format_to(std::back_inserter(line), "{}{}", c == 0 ? "" : ",", value);
  }
  line.push_back('\n');
  return fmt::to_string(line);
}

}  // namespace

void write_channels_csv(const Recording& recording, const std::string& path) {
  std::string text = header(*recording.channels());
  for (std::size_t i = 0; i < recording.frame_count(); ++i) text += row(recording, i);
  write_whole_file(path, FileKind::csv, text);
}

}  // namespace netpocket
