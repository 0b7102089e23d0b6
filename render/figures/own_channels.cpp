#include "render/figures/own_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "render/figures/control_loops.h"
#include "render/figures/peak_marker.h"
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

// What names differ in: "attitude_x" has the stem "attitude" and the component "x"; "wheel_momentum_2" has "2".
std::string stem_of(const std::string& name) { return name.substr(0, name.rfind('_')); }
std::string component_of(const std::string& name) { return name.substr(name.rfind('_') + 1); }

// Channels that are components of one quantity.
using Group = std::vector<ChannelInfo>;

bool belong_together(const ChannelInfo& a, const ChannelInfo& b) {
  return a.unit == b.unit && a.meaning == b.meaning && stem_of(a.name) == stem_of(b.name);
}

// Those of control loops have a figure of their own.
std::vector<Group> groups_of(const RunSeries& run) {
  std::vector<Group> groups;
  const std::set<std::string> of_loops = loop_channels(run);
  for (const ChannelInfo& channel : *run.channel_list) {
    if (!is_own(channel) || of_loops.contains(channel.name)) continue;
    if (groups.empty() || !belong_together(groups.back().back(), channel)) groups.emplace_back();
    groups.back().push_back(channel);
  }
  return groups;
}

// "kg m^2/s" with its powers raised.
std::string unit_text(const std::string& unit) {
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] != '^') {
      text += plain_text(unit.substr(i, 1));
      continue;
    }
    const std::size_t end = std::min(unit.find_first_not_of("-0123456789", i + 1), unit.size());
    text += "^{" + plain_text(unit.substr(i + 1, end - i - 1)) + "}";
    i = end - 1;
  }
  return text;
}

std::string axis_title(const Group& group) {
  const ChannelInfo& first = group.front();
  const std::string words = plain_text(words_of(group.size() > 1 ? stem_of(first.name) : first.name));
  return first.unit == "1" ? words : fmt::format("{} ({})", words, unit_text(first.unit));
}

// One run: a colour for each component. Several: a colour for each run and a dash for each component.
Curve curve_of(const RunSeries& run, std::size_t channel, std::size_t colour, std::size_t dash) {
  constexpr double kDash = 3;  // points
  Curve curve;
  curve.x = run.times();
  curve.y = run.channels[channel];
  curve.colour = kRunColours[colour % kRunColours.size()];
  if (dash > 0) curve.dash = {kDash / static_cast<double>(dash), kDash / 2};
  return curve;
}

void mark_peak(Panel& panel, const RunSeries& run, const std::string& channel) {
  constexpr double kLeast = 1e-3;  // N
  const auto index = run.channel_list->find(channel);
  if (!index) return;
  auto peak = peak_marker(run.times(), run.channels[*index], "N", kLeast);
  if (!peak) return;
  peak->name = fmt::format("{}: largest {}", run.name, channel);
  panel.curves.push_back(std::move(*peak));
}

Panel panel_of(const Group& group, const std::vector<RunSeries>& runs) {
  Panel panel;
  const ChannelInfo& first = group.front();
  panel.title = plain_text(words_of(first.meaning.empty() ? first.name : first.meaning));
  panel.x.title = "Time (s)";
  panel.y.title = axis_title(group);
  panel.phases = common_phases(runs);
  const bool one_run = runs.size() == 1;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (std::size_t component = 0; component < group.size(); ++component) {
      const auto index = runs[run].channel_list->find(group[component].name);
      if (!index) continue;
      Curve curve = one_run ? curve_of(runs[run], *index, component, component / kRunColours.size())
                            : curve_of(runs[run], *index, run, component);
      curve.name = fmt::format("{}: {}", runs[run].name, group[component].name);
      std::string label = one_run ? "" : plain_text(runs[run].name);
      if (group.size() > 1) {
        label += (label.empty() ? "" : " ") + plain_text(component_of(group[component].name));
      }
      curve.label = std::move(label);
      panel.curves.push_back(std::move(curve));
    }
  }
  if (one_run && group.size() == 1 && first.unit == "N") {
    mark_peak(panel, runs.front(), first.name);
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
  for (const Group& group : groups_of(runs.front())) figure.panels.push_back(panel_of(group, runs));
  if (figure.panels.empty()) figure.panels.emplace_back();  // says that there is no data
  const std::size_t columns = std::min(kColumns, figure.panels.size());
  figure.columns = static_cast<int>(columns);
  const std::size_t rows = (figure.panels.size() + columns - 1) / columns;
  figure.height_mm = kTitleRoom + kPanelHeight * static_cast<double>(rows);
  return figure;
}

}  // namespace netpocket
