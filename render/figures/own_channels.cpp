#include "render/figures/own_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "render/figures/phase_bands.h"
#include "render/figures/rich_text.h"

namespace netpocket {
namespace {

constexpr double kPanelHeight = 62;  // mm
constexpr double kTitleRoom = 8;     // mm
constexpr std::size_t kColumns = 2;

bool is_own(const ChannelInfo& channel) { return !known_channels()->find(channel.name).has_value(); }

// "corner_height" -> "Corner height".
std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::string axis_title(const ChannelInfo& channel) {
  const std::string words = plain_text(words_of(channel.name));
  return channel.unit == "1" ? words : fmt::format("{} ({})", words, plain_text(channel.unit));
}

Panel panel_of(const ChannelInfo& channel, const std::vector<RunSeries>& runs) {
  Panel panel;
  std::string meaning = channel.meaning.empty() ? channel.name : channel.meaning;
  panel.title = plain_text(words_of(std::move(meaning)));
  panel.x.title = "Time (s)";
  panel.y.title = axis_title(channel);
  panel.phases = common_phases(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto index = runs[i].channel_list->find(channel.name);
    if (!index) continue;
    Curve curve;
    curve.x = runs[i].times();
    curve.y = runs[i].channels[*index];
    curve.colour = kRunColours[i % kRunColours.size()];
    if (runs.size() > 1) curve.label = plain_text(runs[i].name);
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

}  // namespace

bool has_own_channels(const RunSeries& run) { return std::ranges::any_of(*run.channel_list, is_own); }

Figure own_channels_figure(const std::vector<RunSeries>& runs) {
  Figure figure;
  figure.title = runs.size() == 1 && !runs.front().name.empty()
                     ? fmt::format("Channels of the system: {}", plain_text(runs.front().name))
                     : "Channels of the system";
  for (const ChannelInfo& channel : *runs.front().channel_list) {
    if (is_own(channel)) figure.panels.push_back(panel_of(channel, runs));
  }
  if (figure.panels.empty()) figure.panels.emplace_back();  // says that there is no data
  const std::size_t columns = std::min(kColumns, figure.panels.size());
  figure.columns = static_cast<int>(columns);
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  figure.height_mm = kTitleRoom + kPanelHeight * static_cast<double>(rows);
  return figure;
}

}  // namespace netpocket
