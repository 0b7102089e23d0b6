#include "render/figures/control_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/figures/phase_bands.h"
#include "render/figures/rich_text.h"

namespace netpocket {
namespace {

constexpr double kRowHeight = 62;  // mm
constexpr double kHeadRoom = 8;    // mm
constexpr std::size_t kMostColumns = 2;
constexpr const char* kAxes[] = {"x", "y", "z"};
const std::vector<double> kDashes = {3, 2};  // points

using Names = std::vector<std::string>;
// Loops that share a row.
using LoopRow = std::vector<ControlLoopInfo>;

std::vector<LoopRow> rows_of(const std::vector<ControlLoopInfo>& loops) {
  std::vector<LoopRow> rows;
  for (const ControlLoopInfo& loop : loops) {
    const bool joins = !rows.empty() && rows.back().back().table == loop.table && !loop.table.empty();
    if (!joins) rows.emplace_back();
    rows.back().push_back(loop);
  }
  return rows;
}

const std::vector<double>* values_of(const RunSeries& run, const std::string& channel) {
  const auto index = run.channel_list->find(channel);
  return index ? &run.channels[*index] : nullptr;
}

// Size of a vector over time; empty when the run lacks a component.
std::vector<double> sizes_of(const RunSeries& run, const Names& channels) {
  std::vector<double> squares;
  for (const std::string& name : channels) {
    const std::vector<double>* values = values_of(run, name);
    if (values == nullptr) return {};
    squares.resize(values->size(), 0.0);
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] += (*values)[i] * (*values)[i];
  }
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

std::string size_name(const Names& channels) { return fmt::format("size of ({})", fmt::join(channels, ", ")); }

std::vector<double> differences(const RunSeries& run, const std::string& minuend, const std::string& subtrahend) {
  const auto *a = values_of(run, minuend), *b = values_of(run, subtrahend);
  if (a == nullptr || b == nullptr) return {};
  std::vector<double> result(a->size());
  std::ranges::transform(*a, *b, result.begin(), std::minus<>());
  return result;
}

// `shown`: a channel, or what is made of channels.
Curve curve_with(const RunSeries& run, const std::string& shown, std::vector<double> values, std::size_t colour,
                 const std::string& label) {
  Curve curve;
  curve.x = run.times();
  curve.y = std::move(values);
  curve.colour = kRunColours[colour % kRunColours.size()];
  curve.label = label;
  if (!run.name.empty()) curve.name = fmt::format("{}: {}", run.name, shown);
  return curve;
}

class LoopFigure {
 public:
  // `only`: name of a loop whose row is wanted; empty: all.
  explicit LoopFigure(const std::vector<RunSeries>& runs, std::string only = "")
      : runs_(runs), only_(std::move(only)) {}

  Figure make() {
    for (const LoopRow& row : rows_of(runs_.front().loops)) {
      if (!only_.empty() && std::ranges::find(row, only_, &ControlLoopInfo::name) == row.end()) continue;
      add_tracking(row);
      add_effort(row);
    }
    add_disturbances();
    if (figure_.panels.empty()) figure_.panels.emplace_back();  // says that there is no data
    figure_.title = "Control loops";
    if (is_one() && !runs_.front().name.empty()) figure_.title += ": " + plain_text(runs_.front().name);
    const std::size_t most = only_.empty() ? kMostColumns : 1;
    figure_.columns = static_cast<int>(std::min(most, figure_.panels.size()));
    const auto columns = static_cast<std::size_t>(figure_.columns);
    figure_.height_mm = kHeadRoom + kRowHeight * static_cast<double>((figure_.panels.size() + columns - 1) / columns);
    return figure_;
  }

 private:
  bool is_one() const { return runs_.size() == 1; }
  std::string unit_of(const Names& channels) const {
    const auto index = channels.empty() ? std::nullopt : runs_.front().channel_list->find(channels.front());
    return index ? (*runs_.front().channel_list)[*index].unit : "";
  }

  Panel panel(const std::string& title, const std::string& quantity, const Names& channels) const {
    Panel panel;
    panel.title = plain_text(title);
    panel.x.title = "Time (s)";
    std::string words = quantity;
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    panel.y.title = plain_text(fmt::format("{} ({})", words, unit_of(channels)));
    panel.phases = common_phases(runs_);
    return panel;
  }

  // Dashed, and without an entry in the legend: its neighbour has the same colour.
  static void add_dashed(Panel& panel, Curve curve) {
    curve.dash = kDashes;
    curve.label.clear();
    panel.curves.push_back(std::move(curve));
  }

  // One curve for each run.
  void add_sizes(Panel& panel, const Names& channels) const {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      std::vector<double> sizes = sizes_of(runs_[run], channels);
      if (!sizes.empty())
        panel.curves.push_back(curve_with(runs_[run], size_name(channels), sizes, run, plain_text(runs_[run].name)));
    }
  }

  void add_components(Panel& panel, const Names& channels, const Names& dashed) const {
    const RunSeries& run = runs_.front();
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const std::vector<double>* values = values_of(run, channels[i]);
      if (values == nullptr) continue;
      panel.curves.push_back(curve_with(run, channels[i], *values, i, channels.size() > 1 ? kAxes[i % 3] : ""));
      const std::vector<double>* other = i < dashed.size() ? values_of(run, dashed[i]) : nullptr;
      if (other != nullptr) add_dashed(panel, curve_with(run, dashed[i], *other, i, ""));
    }
  }

  static std::string title_of(const LoopRow& row) {
    return row.size() == 1 ? row.front().name : fmt::format("{} to {}", row.front().name, row.back().name);
  }

  void add_tracking(const LoopRow& row) {
    const ControlLoopInfo& first = row.front();
    if (first.actual.empty()) return;
    if (first.actual.size() == 1) {
      Panel values = panel(title_of(row) + ": actual; dashed: set point", first.quantity, first.actual);
      for (std::size_t run = 0; run < runs_.size(); ++run) add_scalars(values, row, run);
      figure_.panels.push_back(std::move(values));
      return;
    }
    const char* what = is_one() ? ": error" : ": size of the error";
    Panel errors = panel(title_of(row) + what, first.quantity + " error", first.actual);
    if (!is_one() && !first.error.empty()) {
      add_sizes(errors, first.error);
    } else if (!first.error.empty()) {
      add_components(errors, first.error, {});
    } else {
      add_differences(errors, first);
    }
    figure_.panels.push_back(std::move(errors));
  }

  // The same set point in several runs is drawn as often, which looks like one.
  void add_scalars(Panel& panel, const LoopRow& row, std::size_t run) const {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::vector<double>* values = values_of(runs_[run], row[i].actual.front());
      if (values == nullptr) continue;
      const std::size_t colour = is_one() ? i : run;
      const std::string name = is_one() ? (row.size() > 1 ? std::to_string(i + 1) : "") : runs_[run].name;
      panel.curves.push_back(
          curve_with(runs_[run], row[i].actual.front(), *values, colour, i == 0 || is_one() ? plain_text(name) : ""));
      const bool has_set_point = !row[i].set_point.empty();
      const auto* wanted = has_set_point ? values_of(runs_[run], row[i].set_point.front()) : nullptr;
      if (wanted != nullptr) add_dashed(panel, curve_with(runs_[run], row[i].set_point.front(), *wanted, colour, ""));
    }
  }

  void add_differences(Panel& panel, const ControlLoopInfo& loop) const {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      for (std::size_t i = 0; i < std::min(loop.actual.size(), loop.set_point.size()); ++i) {
        const std::string label = is_one() ? kAxes[i % 3] : runs_[run].name;
        panel.curves.push_back(curve_with(runs_[run], fmt::format("{} - {}", loop.actual[i], loop.set_point[i]),
                                          differences(runs_[run], loop.actual[i], loop.set_point[i]),
                                          is_one() ? i : run, is_one() || i == 0 ? plain_text(label) : ""));
      }
    }
  }

  void add_effort(const LoopRow& row) {
    const ControlLoopInfo& first = row.front();
    if (first.delivered.empty()) return;
    const std::string quantity = unit_of(first.delivered) == "N" ? "force" : "torque";
    const bool dashed = is_one() && !first.commanded.empty();
    const std::string what = dashed ? ": delivered; dashed: commanded" : ": delivered";
    Panel efforts = panel(title_of(row) + what, quantity, first.delivered);
    if (first.delivered.size() == 1) {
      for (std::size_t run = 0; run < runs_.size(); ++run) {
        LoopRow as_actual = row;
        for (ControlLoopInfo& loop : as_actual) {
          loop.actual = loop.delivered;
          loop.set_point = is_one() ? loop.commanded : Names();
        }
        add_scalars(efforts, as_actual, run);
      }
    } else if (is_one()) {
      add_components(efforts, first.delivered, first.commanded);
    } else {
      add_sizes(efforts, first.delivered);
    }
    figure_.panels.push_back(std::move(efforts));
  }

  // Channels "disturbance_on_BODY_force_x" that are not always 0.
  void add_disturbances() {
    constexpr std::string_view kBegin = "disturbance_on_", kEnd = "_x";
    for (const ChannelInfo& channel : *runs_.front().channel_list) {
      if (!channel.name.starts_with(kBegin) || !channel.name.ends_with(kEnd)) continue;
      const std::string stem = channel.name.substr(0, channel.name.size() - 1);
      const Names names = {stem + "x", stem + "y", stem + "z"};
      const bool acts = std::ranges::any_of(runs_, [&](const RunSeries& run) {
        return std::ranges::any_of(sizes_of(run, names), [](double size) { return size > 0; });
      });
      if (!acts) continue;
      const std::string quantity = channel.unit == "N" ? "force" : "torque";
      std::string title = stem.substr(0, stem.size() - 2 - quantity.size());
      title[0] = 'D';
      std::ranges::replace(title, '_', ' ');
      Panel disturbance = panel(title, quantity, names);
      if (is_one()) {
        add_components(disturbance, names, {});
      } else {
        add_sizes(disturbance, names);
      }
      figure_.panels.push_back(std::move(disturbance));
    }
  }

  const std::vector<RunSeries>& runs_;
  std::string only_;
  Figure figure_;
};

}  // namespace

bool has_control_loops(const RunSeries& run) { return !run.loops.empty(); }

std::set<std::string> loop_channels(const RunSeries& run) {
  std::set<std::string> names;
  for (const ControlLoopInfo& loop : run.loops) {
    for (const LoopQuantity& quantity : kLoopQuantities) {
      if (quantity.channels == &ControlLoopInfo::disturbance) continue;
      names.insert((loop.*quantity.channels).begin(), (loop.*quantity.channels).end());
    }
  }
  return names;
}

Figure control_loops_figure(const std::vector<RunSeries>& runs) { return LoopFigure(runs).make(); }

Figure control_loop_figure(const std::vector<RunSeries>& runs, const std::string& loop) {
  const auto& loops = runs.front().loops;
  const bool exists = std::ranges::find(loops, loop, &ControlLoopInfo::name) != loops.end();
  return LoopFigure(runs, exists ? loop : "").make();
}

}  // namespace netpocket
