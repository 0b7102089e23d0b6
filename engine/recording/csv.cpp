#include "engine/recording/csv.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "engine/recording/recording.h"

namespace netpocket {

namespace {

std::string header() {
  std::vector<std::string_view> names;
  for (const ChannelInfo& channel : kChannels) names.push_back(channel.name);
  return fmt::format("{}\n", fmt::join(names, ","));
}

std::string row(const Recording& recording, std::size_t frame) {
  fmt::memory_buffer line;
  for (std::size_t c = 0; c < kChannelCount; ++c) {
    const double value = recording.channel(static_cast<Channel>(c))[frame];
    fmt::format_to(std::back_inserter(line), "{}{}", c == 0 ? "" : ",", value);
  }
  line.push_back('\n');
  return fmt::to_string(line);
}

}  // namespace

void write_channels_csv(const Recording& recording, const std::string& path) {
  const std::string part = path + ".part";
  errno = 0;
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out << header();
  for (std::size_t i = 0; i < recording.frame_count() && out; ++i) out << row(recording, i);
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, path, error);
  if (out && !error) return;
  const std::string reason = error ? error.message() : std::strerror(errno);
  std::filesystem::remove(part, error);
  throw RecordingError(fmt::format("cannot write \"{}\": {}", path, reason));
}

}  // namespace netpocket
