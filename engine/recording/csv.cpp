#include "engine/recording/csv.h"

#include <fmt/format.h>

#include "engine/files/whole_file.h"
#include "engine/recording/recording.h"
#include "engine/recording/written_time.h"

namespace netpocket {

namespace {

std::string header() {
  std::vector<std::string_view> names;
  names.reserve(kChannelCount);
  for (const ChannelInfo& channel : kChannels) names.push_back(channel.name);
  return fmt::format("{}\n", fmt::join(names, ","));
}

std::string row(const Recording& recording, std::size_t frame) {
  fmt::memory_buffer line;
  for (std::size_t c = 0; c < kChannelCount; ++c) {
    const auto channel = static_cast<Channel>(c);
    const double recorded = recording.channel(channel)[frame];
    const double value = channel == Channel::time ? written_time(recorded) : recorded;
    fmt::format_to(std::back_inserter(line), "{}{}", c == 0 ? "" : ",", value);
  }
  line.push_back('\n');
  return fmt::to_string(line);
}

}  // namespace

void write_channels_csv(const Recording& recording, const std::string& path) {
  std::string text = header();
  for (std::size_t i = 0; i < recording.frame_count(); ++i) text += row(recording, i);
  write_whole_file(path, FileKind::csv, text);
}

}  // namespace netpocket
