#include "engine/control/observed.h"

#include <algorithm>

#include "engine/control/attitude_error.h"
#include "engine/math/rotation.h"

namespace netpocket {
namespace {

// The vector that a kind of sensor measures, other than the attitude.
Eigen::Vector3d& vector_of(SensorKind kind, Observed& observed) {
  switch (kind) {
    case SensorKind::angular_velocity:
      return observed.craft.angular_velocity;
    case SensorKind::position:
      return observed.craft.position;
    case SensorKind::velocity:
      return observed.craft.velocity;
    case SensorKind::target_position:
      return observed.target.position;
    case SensorKind::target_velocity:
      return observed.target.velocity;
    case SensorKind::contact_force:
    case SensorKind::attitude:
    case SensorKind::rope_tension:
      break;
  }
  return observed.contact_force;
}

}  // namespace

SensorChannel sensor_channel(const SensorParameters& sensor, std::size_t size) {
  SensorSettings settings{.rate = sensor.rate,
                          .delay = sensor.delay,
                          .dropout = sensor.dropout,
                          .noise = std::vector<double>(size, sensor.noise),
                          .seed = static_cast<std::uint64_t>(sensor.seed)};
  for (std::size_t i = 0; i < size; ++i) {
    settings.bias.push_back(sensor.bias[size == 3 ? static_cast<Eigen::Index>(i) : 0]);
  }
  return {settings, size};
}

Sensors::Sensors(const std::vector<SensorParameters>& sensors) {
  for (const SensorParameters& sensor : sensors) {
    if (sensor.kind != SensorKind::rope_tension) entries_.push_back({sensor.kind, sensor_channel(sensor, 3)});
  }
}

Observed Sensors::look(double time, const Observed& truth) {
  Observed known = truth;
  for (Entry& entry : entries_) {
    const bool is_attitude = entry.kind == SensorKind::attitude;
    const Eigen::Vector3d value = is_attitude ? rotation_vector(truth.craft.attitude) : vector_of(entry.kind, known);
    entry.channel.look(time, std::span<const double>(value.data(), 3));
    const Eigen::Vector3d reading(entry.channel.reading().data());
    if (is_attitude) {
      known.craft.attitude = rotation_by(reading);
    } else {
      vector_of(entry.kind, known) = reading;
    }
  }
  return known;
}

void Sensors::visit_state(const NumberVisitor& visit) {
  for (Entry& entry : entries_) entry.channel.visit_state(visit);
}

}  // namespace netpocket
