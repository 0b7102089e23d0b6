#include "engine/analysis/paper/push_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/state/pocket_groups.h"

namespace netpocket {
namespace {

// Height difference to the kinks, as a fraction of the rods' height, from which a cord lies above or below them.
constexpr double kKinkRow = 1e-3;
constexpr double kReach = 0.1 + 1e-6;  // s; the margin is for frame times, which are sums of steps

double mean_height(const Snapshot& frame, const std::vector<std::int32_t>& nodes) {
  double sum = 0;
  for (const std::int32_t node : nodes) sum += frame.positions(1, node);
  return sum / static_cast<double>(nodes.size());
}

std::vector<Region> element_regions(const Structure& structure, const Snapshot& start) {
  const double kinks = mean_height(start, structure.nodes(kRodKinks));
  const double margin = kKinkRow * std::abs(mean_height(start, structure.nodes(kRodTips)) -
                                            mean_height(start, structure.nodes(kRodRoots)));
  std::vector<Region> regions;
  for (const StructureElement& element : structure.elements) {
    const double height = mean_height(start, {element.node[0], element.node[1]});
    regions.push_back(height > kinks + margin   ? Region::mouth
                      : height < kinks - margin ? Region::cone
                                                : Region::kink_row);
  }
  return regions;
}

}  // namespace

double RegionImpulse::total() const { return std::accumulate(by_region.begin(), by_region.end(), unassigned); }

// Adding 0.0 turns -0 into 0.
double RegionImpulse::share(Region region) const { return 0.0 + by_region[static_cast<std::size_t>(region)] / total(); }
double RegionImpulse::share_unassigned() const { return 0.0 + unassigned / total(); }

PushRegions::PushRegions(const RunHistory& run) : run_(run) {
  const Structure& structure = run.recording().structure();
  if (structure.nodes(kRodRoots).empty() || structure.nodes(kRodKinks).empty() || structure.nodes(kRodTips).empty()) {
    missing_ = "the recording has no rods with kinks";
    return;
  }
  const auto& counts = run.channel(Channel::contact_count);
  const auto touching = std::ranges::find_if(counts, [](double count) { return count > 0; });
  if (touching != counts.end() &&
      run.recording().contacts(static_cast<std::size_t>(touching - counts.begin())).empty()) {
    missing_ = "the recording has no contact points";
    return;
  }
  const std::vector<Region> regions = element_regions(structure, run.recording().frame(0));
  forces_.resize(run.times().size());
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (counts[i] > 0) forces_[i] = forces(i, regions);
  }
}

PushRegions::FrameForces PushRegions::forces(std::size_t frame, const std::vector<Region>& regions) const {
  FrameForces sum;
  const auto& bodies = run_.recording().structure().bodies;
  for (const ContactPoint& point : run_.recording().contacts(frame)) {
    // Contacts with another body belong to no part of the pocket.
    if (point.element < 0 || bodies[static_cast<std::size_t>(point.body)].role != BodyRole::target) continue;
    const double force = point.force.y();
    sum.y[static_cast<std::size_t>(regions[static_cast<std::size_t>(point.element)])] += force;
    sum.size += std::abs(force);
    sum.moment += std::abs(force) * point.position.y();
  }
  return sum;
}

std::array<double, kRegionCount> PushRegions::parts(std::size_t frame, double impulse) const {
  const std::vector<double>& times = run_.times();
  std::array<double, kRegionCount> part{};
  const auto add = [&](std::size_t i) {
    for (std::size_t r = 0; r < kRegionCount; ++r) {
      part[r] += std::max(0.0, impulse > 0 ? forces_[i].y[r] : -forces_[i].y[r]);
    }
  };
  // Begins with the frames at the interval's ends and continues outwards.
  for (std::size_t away = 0;; ++away) {
    const bool before = frame >= away + 1 && times[frame - 1] - times[frame - 1 - away] <= kReach;
    const bool after = frame + away < times.size() && times[frame + away] - times[frame] <= kReach;
    if (before) add(frame - 1 - away);
    if (after) add(frame + away);
    const bool found = std::ranges::any_of(part, [](double p) { return p > 0; });
    if (found || (!before && !after)) return part;
  }
}

RegionImpulse PushRegions::impulse(FrameRange range) const {
  RegionImpulse result;
  double size = 0, moment = 0;
  for (std::size_t i = range.first; i < range.last; ++i) {
    const double impulse = run_.interval(i) * run_.channel(Channel::contact_fy)[i];
    if (impulse != 0) {
      const std::array<double, kRegionCount> part = parts(i, impulse);
      const double all = std::accumulate(part.begin(), part.end(), 0.0);
      if (all == 0) result.unassigned += impulse;
      for (std::size_t r = 0; all > 0 && r < kRegionCount; ++r) result.by_region[r] += impulse * part[r] / all;
    }
    size += forces_[i].size;
    moment += forces_[i].moment;
  }
  if (size > 0) result.mean_height = moment / size;
  return result;
}

}  // namespace netpocket
