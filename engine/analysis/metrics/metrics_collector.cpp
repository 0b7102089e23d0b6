#include <algorithm>
#include <cmath>

#include "engine/analysis/metrics/convex_hull.h"
#include "engine/analysis/metrics/cord_utilisation.h"
#include "engine/analysis/metrics/metrics.h"
#include "engine/analysis/metrics/mouth_passage.h"
#include "engine/analysis/metrics/net_cover.h"
#include "engine/analysis/metrics/net_flight.h"
#include "engine/analysis/metrics/net_geometry.h"
#include "engine/analysis/metrics/phase_peaks.h"
#include "engine/analysis/metrics/quality_index.h"
#include "engine/analysis/metrics/target_loads.h"

namespace netpocket {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::optional<std::size_t> body_with(const Structure& structure, BodyRole role) {
  for (std::size_t i = 0; i < structure.bodies.size(); ++i) {
    if (structure.bodies[i].role == role) return i;
  }
  return std::nullopt;
}

Eigen::Matrix3Xd positions_of(const Snapshot& snapshot, const std::vector<std::int32_t>& nodes) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = snapshot.positions.col(nodes[i]);
  }
  return points;
}

bool is_touched(const Snapshot& snapshot) {
  return snapshot.channel(Channel::contact_count) > 0 || snapshot.channel(Channel::contact_fx) != 0 ||
         snapshot.channel(Channel::contact_fy) != 0 || snapshot.channel(Channel::contact_fz) != 0;
}

// "left panel" -> "left_panel".
std::string as_name(std::string text) {
  std::ranges::replace(text, ' ', '_');
  return text;
}

}  // namespace

struct MetricsCollector::Impl {
  Impl(const Structure& of, const MetricOptions& with)
      : structure(of),
        options(with),
        nodes(net_nodes(of)),
        elements(net_elements(of)),
        target(body_with(of, BodyRole::target)),
        spacecraft(body_with(of, BodyRole::spacecraft)),
        utilisation(of, with.strengths),
        passage(of, target, with.closing_end),
        peaks(spacecraft, with.phases),
        flight(*of.channels) {
    if (!target) return;
    const StructureBody& body = of.bodies[*target];
    geometry.emplace(body.shape);
    inertia = with.target_inertia.value_or(solid_inertia(body.shape, body.mass));
  }

  void add(const Snapshot& snapshot) {
    if (!first) first = snapshot;
    last = snapshot;
    utilisation.add(snapshot);
    passage.add(snapshot, nodes);
    if (target) loads.add(structure, snapshot, static_cast<std::int32_t>(*target));
    if (std::isnan(first_contact) && is_touched(snapshot)) first_contact = snapshot.time;
    peaks.add(snapshot, !std::isnan(first_contact));
    flight.add(snapshot, !std::isnan(first_contact));
    // Times of frames are sums of steps.
    constexpr double kRoundOff = 1e-9;
    if (history.time.empty() || snapshot.time >= history.time.back() + options.interval - kRoundOff) {
      const auto hull = convex_hull(positions_of(snapshot, nodes));
      history.time.push_back(snapshot.time);
      history.mouth_area.push_back(mouth_area(structure, snapshot));
      history.hull_volume.push_back(hull ? hull->volume : kUnknown);
    }
  }

  double angular_momentum(const Snapshot& snapshot) const {
    const BodyState& body = snapshot.bodies[*target];
    return (inertia * (body.attitude.conjugate() * body.angular_velocity)).norm();
  }

  Metric spin_left() const {
    const double before = first ? angular_momentum(*first) : 0;
    return {"spin_left", "1", "angular momentum of the target about its centre at the end by that at the start",
            before > 0 ? angular_momentum(*last) / before : kUnknown};
  }

  double relative_speed(const Snapshot& snapshot) const {
    return (snapshot.bodies[*target].velocity - snapshot.bodies[*spacecraft].velocity).norm();
  }

  double covered() const {
    return covered_share(geometry->surface_samples, last->bodies[*target], cord_segments(structure, *last, elements),
                         mesh_size(structure));
  }

  double at(const std::optional<Snapshot>& snapshot, Channel channel) const {
    return snapshot ? snapshot->channel(channel) : kUnknown;
  }

  std::vector<Metric> metrics() const;
  void list_mouth(std::vector<Metric>& list) const;
  void list_enclosure(std::vector<Metric>& list) const;
  void list_motion(std::vector<Metric>& list) const;
  void list_loads(std::vector<Metric>& list) const;
  void list_energy(std::vector<Metric>& list) const;
  void list_peaks(std::vector<Metric>& list) const;

  const Structure& structure;
  const MetricOptions options;
  const std::vector<std::int32_t> nodes, elements;  // of cords and ropes
  const std::optional<std::size_t> target, spacecraft;
  std::optional<TargetGeometry> geometry;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  CordUtilisation utilisation;
  MouthPassage passage;
  PhasePeaks peaks;
  NetFlight flight;
  TargetLoads loads;
  MetricHistory history;
  std::optional<Snapshot> first, last;
  double first_contact = kUnknown;
};

void MetricsCollector::Impl::list_mouth(std::vector<Metric>& list) const {
  const double start = first ? mouth_area(structure, *first) : kUnknown;
  const double end = last ? mouth_area(structure, *last) : kUnknown;
  list.push_back({"mouth_area_start", "m^2", "area of the polygon of the rods' tips at the start", start});
  list.push_back({"mouth_area_end", "m^2", "the same at the end", end});
  list.push_back({"closed_time", "s", "time until 95 % of the way to the shortest commanded length between tips",
                  passage.closed_time()});
  list.push_back({"smallest_gap", "m", "between closing ropes and target; negative when pressed in",
                  passage.smallest_gap().value});
  list.push_back({"smallest_gap_time", "s", "when that was", passage.smallest_gap().time});
  list.push_back({"first_contact_time", "s", "first frame in which a cord touches the target", first_contact});
  list.push_back({"escape_depth", "m", "least depth of the target's centre behind the mouth's plane once closed",
                  passage.escape_depth()});
  list.push_back({"escape_opening", "1", "largest width of the closed mouth by the target's smallest extent",
                  passage.escape_opening()});
}

void MetricsCollector::Impl::list_enclosure(std::vector<Metric>& list) const {
  const auto hull_of = [&](const std::optional<Snapshot>& snapshot) {
    return snapshot ? convex_hull(positions_of(*snapshot, nodes)) : std::nullopt;
  };
  const auto before = hull_of(first), after = hull_of(last);
  list.push_back(
      {"hull_volume_start", "m^3", "of the net's convex hull at the start", before ? before->volume : kUnknown});
  list.push_back({"hull_volume_end", "m^3", "the same at the end", after ? after->volume : kUnknown});
  const bool is_known = target && last;
  list.push_back({"covered_share", "1", "of the target's surface within one mesh size under a cord, at the end",
                  is_known ? covered() : kUnknown});
  QualityIndex index{kUnknown, kUnknown, kUnknown};
  ModifiedQualityIndex modified{kUnknown, kUnknown, kUnknown};
  if (is_known && after) {
    const BodyState& body = last->bodies[*target];
    const double opening = mouth_area(structure, *last) / mouth_area(structure, *first);
    index = quality_index(*geometry, body, *after, positions_of(*last, nodes).rowwise().mean());
    modified = modified_quality_index(*geometry, body, *after, opening);
  }
  list.push_back({"quality_index", "1", "capture quality index at the end; 0: perfect", index.value()});
  list.push_back({"quality_volume", "1", "its term of the volumes", index.volume});
  list.push_back({"quality_surface", "1", "its term of the surfaces", index.surface});
  list.push_back({"quality_centre", "1", "its term of the centres", index.centre});
  list.push_back({"modified_index", "1", "modified capture quality index at the end; 0: perfect", modified.value()});
  list.push_back({"modified_outside", "1", "its term of the volume outside the hull", modified.outside});
  list.push_back({"modified_distance", "1", "its term of the distance from the hull", modified.distance});
  list.push_back({"modified_opening", "1", "its term of the mouth", modified.opening});
}

void MetricsCollector::Impl::list_motion(std::vector<Metric>& list) const {
  const auto speed = [&](const auto& snapshot) {
    return snapshot && target && spacecraft ? relative_speed(*snapshot) : kUnknown;
  };
  const auto momentum = [&](const auto& snapshot) {
    return snapshot && target ? angular_momentum(*snapshot) : kUnknown;
  };
  list.push_back({"relative_speed_start", "m/s", "of the target against the spacecraft at the start", speed(first)});
  list.push_back({"relative_speed_end", "m/s", "the same at the end", speed(last)});
  list.push_back(
      {"angular_momentum_start", "N m s", "of the target about its centre of mass at the start", momentum(first)});
  list.push_back({"angular_momentum_end", "N m s", "the same at the end", momentum(last)});
}

void MetricsCollector::Impl::list_loads(std::vector<Metric>& list) const {
  list.push_back({"utilisation_peak", "1", "largest tension of a cord by its strength", utilisation.peak()});
  list.push_back(
      {"utilisation_p99", "1", "what 99 % of the cords' elements never exceed", utilisation.most_elements()});
  if (!target) return;
  // A target that was touched although no frame has contact points: the recording is too old to hold them.
  const bool is_unknown = !std::isnan(first_contact) && loads.largest().empty();
  for (const std::string& part : part_names(structure.bodies[*target].shape)) {
    const auto load = loads.largest().find(part);
    list.push_back({"load_" + as_name(part), "N", "largest contact force on the target's " + part,
                    load != loads.largest().end() ? load->second.force
                    : is_unknown                  ? kUnknown
                                                  : 0});
  }
}

void MetricsCollector::Impl::list_energy(std::vector<Metric>& list) const {
  for (const Channel channel : {Channel::energy_dissipated, Channel::spent_in_cords, Channel::spent_at_hinges,
                                Channel::spent_in_contacts, Channel::spent_by_friction}) {
    const ChannelInfo& info = channel_info(channel);
    list.push_back({info.name, info.unit, info.meaning, at(last, channel)});
  }
}

void MetricsCollector::Impl::list_peaks(std::vector<Metric>& list) const {
  list.push_back(
      {"attitude_peak", "rad", "largest angle of the spacecraft from its attitude at the start", peaks.attitude()});
  list.push_back({"impact_attitude", "rad",
                  "largest angle from its attitude at the start, from first contact until the towing", peaks.impact()});
  list.push_back({"closing_tension_peak", "N", "largest tension of the closing ropes, mean over the sides, in closing",
                  peaks.closing_tension()});
  list.push_back({"closing_tension_end", "N",
                  "tension of the closing ropes, mean over the sides and the last fifth of the closing",
                  peaks.end_tension()});
  list.push_back(
      {"towing_force_peak", "N", "largest pull of the pocket on the target along -Y in towing", peaks.towing_force()});
  list.push_back({"towing_thrust_peak", "N", "largest thrust of the spacecraft's controllers along -Y in towing",
                  peaks.towing_thrust()});
}

std::vector<Metric> MetricsCollector::Impl::metrics() const {
  std::vector<Metric> list;
  list_mouth(list);
  list_enclosure(list);
  list_motion(list);
  list_loads(list);
  list_energy(list);
  list_peaks(list);
  flight.list(list);
  if (flight.is_of_run() && target) list.push_back(spin_left());
  return list;
}

MetricsCollector::MetricsCollector(const Structure& structure, const MetricOptions& options)
    : impl_(std::make_unique<Impl>(structure, options)) {}
MetricsCollector::~MetricsCollector() = default;
MetricsCollector::MetricsCollector(MetricsCollector&&) noexcept = default;

void MetricsCollector::add(const Snapshot& snapshot) { impl_->add(snapshot); }
std::vector<Metric> MetricsCollector::metrics() const { return impl_->metrics(); }
const MetricHistory& MetricsCollector::history() const { return impl_->history; }

}  // namespace netpocket
