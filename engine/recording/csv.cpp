#include "engine/recording/csv.h"

#include <fmt/format.h>

#include <vector>

#include "engine/files/whole_file.h"
#include "engine/recording/recording.h"
#include "engine/recording/written_time.h"

namespace netpocket {

namespace {

std::vector<Channel> recorded_channels(const Recording& recording) {
  std::vector<Channel> channels;
  for (std::size_t c = 0; c < kChannelCount; ++c) {
    if (recording.has_channel(static_cast<Channel>(c))) channels.push_back(static_cast<Channel>(c));
  }
  return channels;
}

std::string header(const std::vector<Channel>& channels) {
  std::vector<std::string_view> names;
  names.reserve(channels.size());
  for (const Channel channel : channels) names.push_back(channel_info(channel).name);
  return fmt::format("{}\n", fmt::join(names, ","));
}

std::string row(const Recording& recording, const std::vector<Channel>& channels, std::size_t frame) {
  fmt::memory_buffer line;
  for (const Channel channel : channels) {
    const double recorded = recording.channel(channel)[frame];
    const double value = channel == Channel::time ? written_time(recorded) : recorded;
    fmt::format_to(std::back_inserter(line), "{}{}", line.size() == 0 ? "" : ",", value);
  }
  line.push_back('\n');
  return fmt::to_string(line);
}

}  // namespace

void write_channels_csv(const Recording& recording, const std::string& path) {
  const std::vector<Channel> channels = recorded_channels(recording);
  std::string text = header(channels);
  for (std::size_t i = 0; i < recording.frame_count(); ++i) text += row(recording, channels, i);
  write_whole_file(path, FileKind::csv, text);
}

}  // namespace netpocket
