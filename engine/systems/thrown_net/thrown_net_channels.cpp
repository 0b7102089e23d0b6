#include "engine/systems/thrown_net/thrown_net_channels.h"

#include <algorithm>

#include "engine/systems/tether_winch.h"

namespace netpocket {
namespace {

Eigen::Matrix3Xd start_positions(const Model& model) {
  Eigen::Matrix3Xd positions(3, static_cast<Eigen::Index>(model.nodes.size()));
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = model.nodes[i].position;
  }
  return positions;
}

}  // namespace

ThrownNetChannels::ThrownNetChannels(const ThrownNet& net)
    : infos_(common_channels(true, true)),
      first_own_(infos_.size()),
      surface_(net.pattern, net.knots),
      own_area_(net.pattern.area),
      start_(surface_.centre(start_positions(net.model))),
      target_(net.target),
      corner_masses_(net.corner_masses),
      net_elements_(net.net_elements),
      tether_end_(net.tether_end),
      tether_rope_(net.tether_rope),
      drawstrings_(net.drawstring_count()),
      rings_(drawstrings_ - net.model.ropes.size()) {
  // In the order of `fill`.
  infos_.push_back({"net_area", "m^2", "area of the net, the sum of triangles of knots"});
  infos_.push_back({"net_area_part", "1", "area of the net by that of the flat net"});
  infos_.push_back({"mouth_area", "m^2", "vector area of the net's perimeter, magnitude"});
  infos_.push_back({"net_distance", "m", "flight of the middle of the net's knots along Y"});
  infos_.push_back({"corner_speed", "m/s", "speed of the corner masses, mean"});
  infos_.push_back(channel_info(Channel::rope_tension_max));
  infos_.push_back({"enclosure", "1", "solid angle of the net from the target, by 4 pi"});
  infos_.push_back({"captured", "1", "1 while enclosure exceeds 0.5: held (our measure)"});
  if (tether_end_ >= 0 || tether_rope_ >= 0) {
    infos_.push_back({"tether_tension", "N", "tension of the tether at the spacecraft"});
  }
  if (tether_rope_ >= 0) {
    for (const ChannelInfo& info : wound_tether_channels()) infos_.push_back(info);
  }
  if (drawstrings_ == 0) return;
  infos_.push_back({"drawstring_length", "m", "length of a side's drawstring outside the winches"});
  infos_.push_back({"drawstring_tension", "N", "tension of the drawstring, mean over its sides"});
  if (rings_ == 0) return;
  infos_.back().meaning = "tension of the drawstring at the winches, mean";
  infos_.push_back({"drawstring_middle_tension", "N", "tension of the drawstring in the middle of a side, mean"});
}

double ThrownNetChannels::corner_speed(const Snapshot& snapshot) const {
  double sum = 0;
  for (const std::int32_t node : corner_masses_) sum += snapshot.velocities.col(node).norm();
  return sum / static_cast<double>(corner_masses_.size());
}

// N, mean over the sides.
double ThrownNetChannels::middle_tension(const CableSystem& system) const {
  double sum = 0;
  for (std::size_t side = 0; side < rings_; ++side) {
    const std::vector<double> tensions = system.ring_rope_tensions(static_cast<std::int32_t>(side));
    sum += tensions[tensions.size() / 2];
  }
  return sum / static_cast<double>(rings_);
}

void ThrownNetChannels::fill(const CableSystem& system, Snapshot& snapshot) const {
  auto out = snapshot.channels.begin() + static_cast<std::ptrdiff_t>(first_own_);
  const double area = surface_.area(snapshot.positions);
  const double enclosure =
      surface_.enclosure(snapshot.positions, snapshot.bodies[static_cast<std::size_t>(target_)].position);
  double largest = 0;
  for (const std::int32_t element : net_elements_) largest = std::max(largest, snapshot.tension[element]);
  *out++ = area;
  *out++ = area / own_area_;
  *out++ = surface_.mouth_area(snapshot.positions);
  *out++ = (surface_.centre(snapshot.positions) - start_).y();
  *out++ = corner_speed(snapshot);
  *out++ = largest;
  *out++ = enclosure;
  *out++ = enclosure > 0.5 ? 1 : 0;
  if (tether_end_ >= 0) *out++ = snapshot.tension[tether_end_] + 0.0;  // a slack one has -0
  if (tether_rope_ >= 0) {
    *out++ = system.rope_tension(tether_rope_);
    *out++ = system.rope_motion(tether_rope_).length;
    *out++ = system.rope_motion(tether_rope_).rate;
  }
  if (drawstrings_ == 0) return;
  double tension = 0;
  for (std::size_t rope = 0; rope < drawstrings_; ++rope)
    tension += system.rope_tension(static_cast<std::int32_t>(rope));
  *out++ = system.rope_motion(0).length;
  *out++ = tension / static_cast<double>(drawstrings_);
  if (rings_ > 0) *out++ = middle_tension(system);
}

}  // namespace netpocket
