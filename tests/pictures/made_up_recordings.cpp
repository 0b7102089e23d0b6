#include "tests/pictures/made_up_recordings.h"

#include <cmath>

#include "engine/recording/recorder.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/write_scenario.h"
#include "engine/state/pocket_groups.h"
#include "tests/render/figures/synthetic_run.h"
#include "tests/render/synthetic_pocket.h"

namespace netpocket::pictures {
namespace {

constexpr int kFrames = 11;
constexpr double kTargetRadius = 4.5;

RunOrigin made_up_origin(const std::string& name) {
  Scenario scenario;
  scenario.name = name;
  scenario.closing.start = 0;
  scenario.closing.duration = 7.5;
  scenario.towing.mode = TowingMode::acceleration;
  scenario.towing.start = 9;
  RunOrigin origin;
  origin.scenario_name = name;
  origin.scenario_text = write_scenario_text(scenario);
  origin.netpocket_version = std::string("0");  // one character assigned warns wrongly with GCC 12 (its bug 105651)
  origin.commit = "made up";
  origin.phases = pocket_phases(0, 7.5, 9);
  return origin;
}

// Nodes on the sphere's upper half push it inwards, the more the closer they would be to it while closing.
void add_contacts(const Structure& structure, Snapshot& snapshot, double closed) {
  const auto& target = snapshot.bodies[1];
  for (std::size_t i = 0; i < structure.elements.size(); i += 3) {
    const auto& element = structure.elements[i];
    if (element.group != index_of(PocketGroup::net)) continue;
    const Eigen::Vector3d arm = snapshot.positions.col(element.node[0]) - target.position;
    const double gap = arm.norm() - kTargetRadius, reach = 2.2 * closed;
    if (gap > reach || arm.y() < 0) continue;
    ContactPoint contact;
    contact.position = target.position + kTargetRadius * arm.normalized();
    contact.force = -8 * (reach - gap) * arm.normalized();
    contact.element = static_cast<std::int32_t>(i);
    contact.body = 1;
    snapshot.contacts.push_back(contact);
  }
}

Snapshot pocket_frame(const Structure& structure, int frame) {
  const double time = frame, closed = std::min(time / 7.5, 1.0);
  auto snapshot = synthetic::make_snapshot(structure, time, closed);
  auto& target = snapshot.bodies[1];
  target.position += Eigen::Vector3d(0.06 * time, -0.012 * time * time, -0.03 * time);
  add_contacts(structure, snapshot, closed);
  const Channel target_channels[] = {Channel::target_x, Channel::target_y, Channel::target_z};
  const Channel spacecraft_channels[] = {Channel::spacecraft_x, Channel::spacecraft_y, Channel::spacecraft_z};
  snapshot.channel(Channel::time) = time;
  for (int axis = 0; axis < 3; ++axis) {
    snapshot.channel(target_channels[axis]) = target.position[axis];
    snapshot.channel(spacecraft_channels[axis]) = snapshot.bodies[0].position[axis];
  }
  return snapshot;
}

void finish(Recorder& recorder, double end) { recorder.finish({RunReason::finished, end, ""}, {}); }

// Frames without a pocket.
template <typename Fill>
void write_channels(const std::string& path, const RunOrigin& origin, std::size_t frames, Fill&& fill) {
  const Structure nothing;
  Recorder recorder(path, origin, nothing, true);
  Snapshot snapshot;
  snapshot.positions.resize(3, 0);
  snapshot.velocities.resize(3, 0);
  snapshot.gradients.resize(3, 0);
  for (std::size_t i = 0; i < frames; ++i) {
    fill(snapshot, i);
    recorder.write(snapshot);
  }
  finish(recorder, snapshot.time);
}

}  // namespace

void write_pocket_recording(const std::string& path, const std::string& name, const Shape& target) {
  const auto structure = synthetic::make_structure(target);
  Recorder recorder(path, made_up_origin(name), structure, true);
  for (int frame = 0; frame < kFrames; ++frame) recorder.write(pocket_frame(structure, frame));
  finish(recorder, kFrames - 1);
}

void write_broken_recording(const std::string& path) {
  const auto structure = synthetic::make_structure();
  Recorder recorder(path, made_up_origin("broken"), structure, true);
  auto snapshot = pocket_frame(structure, 5);
  for (Eigen::Index node = 0; node < snapshot.positions.cols(); node += 41) snapshot.positions.col(node) *= 1.8;
  snapshot.gradients *= 4;
  snapshot.tension *= 1e6;
  recorder.write(snapshot);
}

void write_series_recording(const std::string& path, const std::string& name, double closing_time) {
  const auto series = synthetic_run(name, closing_time);
  auto origin = made_up_origin(name);
  origin.phases = series.phases;
  write_channels(path, origin, series.times().size(), [&](Snapshot& snapshot, std::size_t i) {
    snapshot.time = series.times()[i];
    for (std::size_t c = 0; c < snapshot.channels.size(); ++c) {
      const auto& values = series.channels[c];
      snapshot.channels[c] = i < values.size() ? values[i] : 0;
    }
  });
}

void write_empty_series_recording(const std::string& path) {
  write_channels(path, made_up_origin("nothing"), 1, [](Snapshot&, std::size_t) {});
}

}  // namespace netpocket::pictures
