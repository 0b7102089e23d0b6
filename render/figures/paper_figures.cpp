#include "render/figures/paper_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "engine/analysis/summary.h"
#include "render/figures/axis_ticks.h"
#include "render/figures/control_loops.h"
#include "render/figures/own_channels.h"
#include "render/figures/peak_marker.h"
#include "render/figures/phase_bands.h"
#include "render/figures/rich_text.h"

namespace netpocket {
namespace {

using Runs = std::vector<RunSeries>;

constexpr double kRowHeight = 62;              // mm
constexpr double kForceRowHeight = 46;         // mm
constexpr double kTitleHeight = 8;             // mm
constexpr std::size_t kPanelsAcross = 3;       // side by side, more runs start another row
constexpr double kSmallestMotion = 1e-6;       // m, less is drawn flat
constexpr double kSmallestAxialMotion = 1e-3;  // m, keeps a body at rest on a readable scale
constexpr double kSmallestForce = 1e-3;        // N, less is drawn flat
constexpr double kThinLine = 0.7;              // points, for curves full of spikes
constexpr const char* kTimeTitle = "Time *t* (s)";

// ---- pieces ----

Curve channel_curve(const RunSeries& run, Channel channel, FigureColour colour, std::string label) {
  Curve curve;
  curve.x = run.times();
  curve.y = run.channel(channel);
  curve.colour = colour;
  curve.label = std::move(label);
  if (!run.name.empty()) curve.name = fmt::format("{}: {}", run.name, channel_info(channel).name);
  return curve;
}

Panel time_panel(std::string title, std::string y_title, std::vector<PhaseBand> bands) {
  Panel panel;
  panel.title = std::move(title);
  panel.x.title = kTimeTitle;
  panel.y.title = std::move(y_title);
  panel.phases = std::move(bands);
  return panel;
}

std::string run_name(const RunSeries& run) { return plain_text(run.name); }

// ", case 1" for one run, nothing for several.
std::string only_run(const Runs& runs) { return runs.size() == 1 ? ", " + run_name(runs.front()) : ""; }

Figure grid(std::string title, std::vector<Panel> panels, std::size_t columns) {
  Figure figure;
  figure.title = std::move(title);
  figure.columns = static_cast<int>(std::max<std::size_t>(columns, 1));
  const std::size_t rows = (panels.size() + columns - 1) / std::max<std::size_t>(columns, 1);
  figure.height_mm = kTitleHeight + kRowHeight * static_cast<double>(std::max<std::size_t>(rows, 1));
  figure.panels = std::move(panels);
  return figure;
}

// One curve of a channel for each run; labelled when there are several.
void add_run_curves(Panel& panel, const Runs& runs, Channel channel) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    panel.curves.push_back(channel_curve(runs[i], channel, run_colour(i), runs.size() > 1 ? run_name(runs[i]) : ""));
  }
}

// ---- Figure 3 ----

Curve commanded_curve(const RunSeries& run, Channel channel, FigureColour colour, std::string label) {
  Curve curve = channel_curve(run, channel, lighter(colour, 0.6), std::move(label));
  curve.width = 3;
  return curve;
}

// The commanded law as a broad pale line under the measured one, so that both show where they coincide.
Panel closing_panel(const Runs& runs, Channel commanded, Channel measured, std::string title, std::string y_title) {
  Panel panel = time_panel(std::move(title), std::move(y_title), common_phases(runs));
  const bool single = runs.size() == 1;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    panel.curves.push_back(commanded_curve(runs[i], commanded, run_colour(i), single ? "commanded" : ""));
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    panel.curves.push_back(channel_curve(runs[i], measured, run_colour(i), single ? "measured" : run_name(runs[i])));
  }
  // For several runs one entry says what all pale lines are; it has no points.
  if (!single) panel.curves.push_back(commanded_curve({}, commanded, kGrey, "commanded"));
  return panel;
}

Figure closing_figure(const Runs& runs) {
  return grid(
      "Closing of the mouth" + only_run(runs),
      {closing_panel(runs, Channel::commanded_length, Channel::closing_length, "Distance between adjacent rod tips",
                     "Distance *L* (m)"),
       closing_panel(runs, Channel::commanded_speed, Channel::closing_speed, "Closing speed", "Speed d*L*/d*t* (m/s)")},
      2);
}

// ---- Figures 5 and 9 ----

// Marks the largest force; nothing when there is none.
void add_peak(Panel& panel, const RunSeries& run, const std::vector<double>& force, const std::string& name) {
  std::optional<Curve> peak = peak_marker(run.times(), force, "N", kSmallestForce);
  if (!peak) return;
  peak->name = run.name + ": largest " + name;
  panel.curves.push_back(std::move(*peak));
}

struct ForceComponent {
  const char* symbol;
  Channel channel;
  FigureColour colour;
};

constexpr std::array<ForceComponent, 3> kForces = {{{"*F_{x}*", Channel::contact_fx, kOrange},
                                                    {"*F_{y}*", Channel::contact_fy, kBlue},
                                                    {"*F_{z}*", Channel::contact_fz, kGreen}}};

Panel force_panel(const RunSeries& run, const ForceComponent& force, std::string title) {
  Panel panel = time_panel(std::move(title), fmt::format("Force {} (N)", force.symbol), phase_bands(run));
  panel.y.minimum_span = kSmallestForce;
  panel.curves = {channel_curve(run, force.channel, force.colour, "")};
  panel.curves.front().width = kThinLine;
  if (force.channel == Channel::contact_fy) {
    add_peak(panel, run, run.channel(Channel::contact_fy), channel_info(Channel::contact_fy).name);
  }
  return panel;
}

// A panel for each component, because F_y would hide the others; all runs on the same scale. A few runs stand side by
// side with a row for each component, more have a row each.
Figure force_figure(const Runs& runs) {
  const bool side_by_side = runs.size() <= kPanelsAcross;
  const std::size_t rows = side_by_side ? kForces.size() : runs.size();
  const std::size_t columns = side_by_side ? runs.size() : kForces.size();
  std::vector<Panel> panels;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t force = side_by_side ? row : column;
      const RunSeries& run = runs[side_by_side ? column : row];
      const bool named = runs.size() > 1 && force == 0;
      panels.push_back(force_panel(run, kForces[force], named ? run_name(run) : ""));
      panels.back().y_group = static_cast<int>(force);
    }
  }
  Figure figure = grid("Contact force on the target" + only_run(runs), panels, columns);
  figure.height_mm = kTitleHeight + kForceRowHeight * static_cast<double>(rows);
  return figure;
}

// ---- Figures 6, 10 and 11 ----

struct BodyChannels {
  const char* name;
  Channel x;
  Channel y;
  Channel z;
};

constexpr BodyChannels kTarget = {"Target", Channel::target_x, Channel::target_y, Channel::target_z};
constexpr BodyChannels kSpacecraft = {"Spacecraft", Channel::spacecraft_x, Channel::spacecraft_y,
                                      Channel::spacecraft_z};

// The part of a curve from `begin` to `end`, both included.
Curve between(const Curve& curve, double begin, double end) {
  Curve part = curve;
  part.x.clear();
  part.y.clear();
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    if (curve.x[i] < begin || curve.x[i] > end) continue;
    part.x.push_back(curve.x[i]);
    part.y.push_back(curve.y[i]);
  }
  return part;
}

// Y by phase: blue until towing starts, red from there on.
Panel axial_panel(const RunSeries& run, const BodyChannels& body, std::string title) {
  Panel panel = time_panel(std::move(title), "Position *Y* (m)", phase_bands(run));
  panel.y.minimum_span = kSmallestAxialMotion;
  const Curve whole = channel_curve(run, body.y, kClosingBlue, "");
  const double begin = phase_begin(run.phases, kTowing);
  const double towing_start = std::isfinite(begin) ? begin : INFINITY;
  panel.curves = {between(whole, -INFINITY, towing_start), between(whole, towing_start, INFINITY)};
  panel.curves.back().colour = kTowingRed;
  return panel;
}

Panel lateral_panel(const RunSeries& run, const BodyChannels& body, std::string title) {
  Panel panel = time_panel(std::move(title), "Position *X*, *Z* (m)", phase_bands(run));
  panel.y.minimum_span = kSmallestMotion;
  panel.curves = {channel_curve(run, body.x, kOrange, "*X*"), channel_curve(run, body.z, kGreen, "*Z*")};
  return panel;
}

void add_body_row(std::vector<Panel>& panels, const RunSeries& run, const BodyChannels& body, const std::string& name) {
  panels.push_back(axial_panel(run, body, name + ": axial"));
  panels.push_back(lateral_panel(run, body, name + ": lateral"));
}

void add_overlay_row(std::vector<Panel>& panels, const Runs& runs, const BodyChannels& body) {
  const std::string name = body.name;
  Panel axial = time_panel(name + ": axial", "Position *Y* (m)", common_phases(runs));
  axial.y.minimum_span = kSmallestAxialMotion;
  add_run_curves(axial, runs, body.y);

  Panel lateral = time_panel(name + ": lateral", "Position *X*, *Z* (m)", common_phases(runs));
  lateral.y.minimum_span = kSmallestMotion;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    lateral.curves.push_back(channel_curve(runs[i], body.x, run_colour(i), "*X* " + run_name(runs[i])));
    lateral.curves.push_back(channel_curve(runs[i], body.z, run_colour(i), "*Z* " + run_name(runs[i])));
    lateral.curves.back().dash = {3, 1.5};
  }
  panels.push_back(axial);
  panels.push_back(lateral);
}

Figure position_figure(const Runs& runs) {
  std::vector<Panel> panels;
  for (const BodyChannels& body : {kTarget, kSpacecraft}) {
    if (runs.size() == 1) {
      add_body_row(panels, runs.front(), body, body.name);
    } else {
      add_overlay_row(panels, runs, body);
    }
  }
  return grid("Positions of target and spacecraft" + only_run(runs), panels, 2);
}

Figure body_figure(const Runs& runs, const BodyChannels& body, const std::string& title) {
  std::vector<Panel> panels;
  for (const RunSeries& run : runs) add_body_row(panels, run, body, runs.size() > 1 ? run_name(run) : body.name);
  for (std::size_t i = 0; i < panels.size(); i += 2) panels[i].y_group = 0;  // the same scale of Y for every run
  return grid(title + only_run(runs), panels, 2);
}

Figure target_figure(const Runs& runs) { return body_figure(runs, kTarget, "Position of the target"); }
Figure spacecraft_figure(const Runs& runs) { return body_figure(runs, kSpacecraft, "Position of the spacecraft"); }

// ---- energy and tension ----

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

// "case1: balance" for one run of several, "Balance" for the only one.
std::string row_title(const std::string& name, std::string text) {
  if (!name.empty()) return name + ": " + text;
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

std::string error_title(const RunSeries& run) {
  const double input = largest_size(run.channel(Channel::energy_input));
  if (input < kLeastComparableEnergy) return "error";  // nothing to compare with yet
  const double percent = 100 * largest_size(run.channel(Channel::energy_error)) / input;
  if (percent < 0.001) return "error, below 0.001 % of the input";
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(percent))), 0, 4);
  return fmt::format("error, at most {} % of the input", number_text(percent, decimals));
}

bool is_recorded(const RunSeries& run, Channel channel) {
  return std::ranges::any_of(run.channel(channel), [](double value) { return std::isfinite(value); });
}

Panel balance_panel(const RunSeries& run, const std::string& name) {
  Panel panel = time_panel(row_title(name, "balance"), "Energy (J)", phase_bands(run));
  panel.curves = {channel_curve(run, Channel::energy_input, kBlack, "put in"),
                  channel_curve(run, Channel::energy_kinetic, kBlue, "kinetic"),
                  channel_curve(run, Channel::energy_strain, kVermillion, "strain"),
                  channel_curve(run, Channel::energy_dissipated, kGreen, "dissipated")};
  if (is_recorded(run, Channel::energy_contact)) {
    panel.curves.push_back(channel_curve(run, Channel::energy_contact, kOrange, "contact springs"));
  }
  return panel;
}

// Recordings made before the parts had channels hold their sum alone.
Panel dissipation_panel(const RunSeries& run, const std::string& name) {
  if (!is_recorded(run, Channel::spent_in_cords)) {
    Panel sum = time_panel(row_title(name, "dissipated; parts not recorded"), "Energy (J)", phase_bands(run));
    sum.curves = {channel_curve(run, Channel::energy_dissipated, kGreen, "")};
    return sum;
  }
  Panel panel = time_panel(row_title(name, "dissipated"), "Energy (J)", phase_bands(run));
  panel.curves = {channel_curve(run, Channel::spent_in_cords, kBlue, "in cords"),
                  channel_curve(run, Channel::spent_at_hinges, kVermillion, "at hinges"),
                  channel_curve(run, Channel::spent_in_contacts, kOrange, "in contacts"),
                  channel_curve(run, Channel::spent_by_friction, kSkyBlue, "by friction")};
  return panel;
}

void add_energy_row(std::vector<Panel>& panels, const RunSeries& run, const std::string& name) {
  panels.push_back(balance_panel(run, name));
  panels.push_back(dissipation_panel(run, name));
  Panel error = time_panel(row_title(name, error_title(run)), "Energy error (J)", phase_bands(run));
  error.curves = {channel_curve(run, Channel::energy_error, kPurple, "")};
  panels.push_back(error);
}

Figure energy_figure(const Runs& runs) {
  std::vector<Panel> panels;
  for (const RunSeries& run : runs) add_energy_row(panels, run, runs.size() > 1 ? run_name(run) : "");
  return grid("Energy balance" + only_run(runs), panels, 3);
}

// Tensions of ropes that only this kind of system has, such as a tether.
std::vector<ChannelInfo> own_tensions(const RunSeries& run) {
  std::vector<ChannelInfo> tensions;
  for (const ChannelInfo& channel : *run.channel_list) {
    const bool is_known = known_channels()->find(channel.name).has_value();
    if (!is_known && channel.unit == "N" && channel.name.ends_with("_tension")) tensions.push_back(channel);
  }
  return tensions;
}

// A panel of a tension, for the runs that have its channel.
Panel tension_panel(const Runs& runs, const std::string& channel, std::string title, double width = kThinLine) {
  Panel panel = time_panel(std::move(title), "Tension (N)", common_phases(runs));
  panel.y.minimum_span = kSmallestForce;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto index = runs[i].channel_list->find(channel);
    if (!index) continue;
    Curve curve;
    curve.x = runs[i].times();
    curve.y = runs[i].channels[*index];
    curve.colour = run_colour(i);
    curve.width = width;
    if (runs.size() > 1) curve.label = run_name(runs[i]);
    if (!runs[i].name.empty()) curve.name = fmt::format("{}: {}", runs[i].name, channel);
    panel.curves.push_back(std::move(curve));
    if (runs.size() == 1) add_peak(panel, runs[i], runs[i].channels[*index], channel);
  }
  return panel;
}

Figure tension_figure(const Runs& runs) {
  const ChannelInfo &net = channel_info(Channel::rope_tension_max), &closing = channel_info(Channel::closing_tension);
  std::vector<Panel> panels = {tension_panel(runs, net.name, "Largest tension in a net cord")};
  const auto closes = [](const RunSeries& run) { return run.channel_list->has(Channel::closing_tension); };
  if (std::ranges::any_of(runs, closes)) {
    panels.push_back(tension_panel(runs, closing.name, "Tension in the closing ropes, mean", Curve().width));
  }
  for (const ChannelInfo& own : own_tensions(runs.front())) {
    panels.push_back(tension_panel(runs, own.name, row_title("", plain_text(own.meaning))));
  }
  return grid("Tension" + only_run(runs), panels, std::min<std::size_t>(panels.size(), 2));
}

// ---- names ----

struct NamedFigure {
  const char* name;
  Figure (*make)(const Runs&);
  std::optional<Channel> needed;  // absent: as `suits` says
  bool (*suits)(const RunSeries&) = nullptr;
};

constexpr std::array<NamedFigure, 10> kFigures = {
    {{"figure03_closing", closing_figure, Channel::closing_length},
     {"figure05_force", force_figure, Channel::contact_fy},
     {"figure06_position", position_figure, Channel::target_y},
     {"figure09_force", force_figure, Channel::contact_fy},
     {"figure10_target_position", target_figure, Channel::target_y},
     {"figure11_spacecraft_position", spacecraft_figure, Channel::spacecraft_y},
     {"energy", energy_figure, Channel::energy_kinetic},
     {"tension", tension_figure, Channel::rope_tension_max},
     {"control_loops", control_loops_figure, std::nullopt, has_control_loops},
     {"own_channels", own_channels_figure, std::nullopt, has_own_channels}}};

bool suits(const NamedFigure& figure, const RunSeries& run) {
  return figure.needed ? run.channel_list->has(*figure.needed) : figure.suits(run);
}

// How much two names have in common: letters in the same order (longest common subsequence) over their mean length. A
// part of a name, such as "force", is closer to the whole than an edit distance would say.
double likeness(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1, 0);
  for (const char letter : a) {
    std::size_t diagonal = 0;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = letter == b[j - 1] ? diagonal + 1 : std::max(above, row[j - 1]);
      diagonal = above;
    }
  }
  return 2.0 * static_cast<double>(row.back()) / static_cast<double>(a.size() + b.size());
}

}  // namespace

const std::vector<std::string>& figure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const NamedFigure& figure : kFigures) list.emplace_back(figure.name);
    return list;
  }();
  return names;
}

std::vector<std::string> default_figure_names(const std::vector<RunSeries>& runs) {
  const std::string left_out = runs.size() > 1 ? "figure05_force" : "figure09_force";
  std::vector<std::string> names;
  const std::vector<RunSeries> shown = runs.empty() ? std::vector<RunSeries>(1) : runs;
  for (const NamedFigure& figure : kFigures) {
    const auto has_its_channels = [&](const RunSeries& run) { return suits(figure, run); };
    if (figure.name != left_out && std::ranges::any_of(shown, has_its_channels)) names.emplace_back(figure.name);
  }
  return names;
}

namespace {

// Names the runs that are drafts, unless all are. Their bias is the same.
std::string draft_note_of(const std::vector<RunSeries>& runs) {
  std::string names, notice;
  std::size_t drafts = 0;
  for (const RunSeries& run : runs) {
    if (run.draft.empty()) continue;
    ++drafts;
    names += (names.empty() ? "" : ", ") + run.name;
    notice = run.draft;
  }
  if (drafts == 0) return {};
  return plain_text((drafts == runs.size() ? "Draft: " : "Drafts are " + names + ": ") + notice);
}

}  // namespace

Figure make_figure(std::string_view name, const std::vector<RunSeries>& runs) {
  const std::vector<RunSeries> shown = runs.empty() ? std::vector<RunSeries>(1) : runs;
  for (const NamedFigure& figure : kFigures) {
    if (name != figure.name) continue;
    Figure made = figure.make(shown);
    made.note = draft_note_of(runs);
    return made;
  }
  const auto nearest = std::max_element(kFigures.begin(), kFigures.end(), [&](const auto& a, const auto& b) {
    return likeness(name, a.name) < likeness(name, b.name);
  });
  throw FigureError(fmt::format("unknown figure '{}'; did you mean '{}'?", name, nearest->name));
}

}  // namespace netpocket
