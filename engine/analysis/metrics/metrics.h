#pragma once
// Measures of a capture beyond yes and no, as a list of named numbers. A MetricsCollector computes them during a run,
// from the snapshots as they come, so that a run needs no recording for it; metrics_of() computes the same ones from a
// recording. World frame, SI units.

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/state/phase.h"
#include "engine/state/snapshot.h"
#include "engine/state/structure.h"

namespace netpocket {

class Recording;
struct Scenario;

struct Metric {
  std::string name;     // letters, digits, underscores
  std::string unit;     // "1" for pure numbers
  std::string meaning;  // half a line
  double value;         // NaN: the run has no such quantity, or it did not happen
};

// Quantities over time, at times (s) about MetricOptions::interval apart.
struct MetricHistory {
  std::vector<double> time;         // s
  std::vector<double> mouth_area;   // m^2, area of the polygon of the rods' tips; NaN without a mouth
  std::vector<double> hull_volume;  // m^3, of the convex hull of net and ropes; NaN if they lie in a plane
};

// What a structure does not tell.
struct MetricOptions {
  double closing_end = std::numeric_limits<double>::quiet_NaN();  // s; NaN: unknown
  std::vector<Phase> phases = {};                                 // as far as they are known before the run
  double interval = 0.1;                                          // s between evaluations of the net's geometry
  std::vector<double> strengths = {};  // N, breaking force of cables by element group; 0: not known
  // kg m^2, of the target about its centre of mass, body axes. Without it the shape is taken as filled evenly.
  std::optional<Eigen::Matrix3d> target_inertia = std::nullopt;
};

// Strain at which cords are taken to break if nothing else is known: that of aramid fibres (PPTA, 3.5 %: Teijin,
// Tensile properties of Technora, table 3), of which nets of this kind are made. The strength of a cord is then E A
// times this strain. Knots weaken cords: the same source has a quarter of the strength for knots in Technora. A
// utilisation of 0.25 is therefore no safe one.
inline constexpr double kBreakingStrain = 0.035;

// Options of a pocket: strengths from the moduli and sections of its net and ropes, the target's inertia. Those of
// another kind of capture system are not known.
MetricOptions metric_options(const Scenario& scenario, const Structure& structure);

// Thread contract: one thread at a time per object. The structure must outlive it.
class MetricsCollector {
 public:
  MetricsCollector(const Structure& structure, const MetricOptions& options);
  ~MetricsCollector();
  MetricsCollector(MetricsCollector&&) noexcept;

  // Snapshots in the order of their times.
  void add(const Snapshot& snapshot);
  // All metrics of the snapshots so far. The same structure always has the same names in the same order.
  std::vector<Metric> metrics() const;
  const MetricHistory& history() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

struct MetricsOfRun {
  std::vector<Metric> metrics;
  MetricHistory history;
  std::string draft{};  // RunOrigin::draft: what is said of a draft; empty otherwise
};

// Reads all frames. Takes the end of the closing from the recording if the options do not have it. Throws
// RecordingError.
MetricsOfRun metrics_of(const Recording& recording, const MetricOptions& options);

// A table for people; a header line and a line per metric; {"metrics": {name: {"value", "unit", "meaning"}}, "history":
// {"time", "mouth_area", "hull_volume"}, "draft" of drafts only} with null for NaN.
std::string metrics_text(const std::vector<Metric>& metrics);
std::string metrics_csv(const std::vector<Metric>& metrics);
std::string metrics_json(const MetricsOfRun& run);

}  // namespace netpocket
