#include "tests/engine/recording/synthetic_run.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "engine/state/pocket_groups.h"

namespace netpocket {

Structure synthetic_structure(int elements) {
  Structure structure;
  structure.node_count = elements + 1;
  structure.gradient_count = 2 * elements;
  structure.rope_count = 2;
  structure.threads = {"rod 1", "panel 1 row 1"};
  for (int i = 0; i < elements; ++i) {
    StructureElement element = {{i, i + 1}, {2 * i, 2 * i + 1}};
    element.group = index_of(i < 2 ? PocketGroup::closing_ropes : PocketGroup::net);
    element.thread = i % 2;
    element.rope = i < 2 ? i : -1;
    element.length = 0.5 + 0.001 * i;
    element.radius = 0.002;
    structure.elements.push_back(element);
  }
  structure.bodies = {{"spacecraft", BodyRole::spacecraft, Box{{1.6, 2.0, 1.6}}, 1210},
                      {"target", BodyRole::target, Sphere{4.5}, 200},
                      {"debris", BodyRole::other, Cylinder{0.4, 1.5}, 3}};
  structure.element_groups = pocket_groups();
  structure.node_groups = {{kRodRoots, NodeLook::adapter, {0, 1}},
                           {kRodKinks, NodeLook::joint, {2, 3}},
                           {kRodTips, NodeLook::reel, {4, elements}}};
  return structure;
}

Snapshot synthetic_frame(const Structure& structure, int index) {
  Snapshot s;
  s.time = 0.02 * index;
  s.step = 100 * index;
  // Noise in the last digits, as in a real run: it is what makes node data hard to compress.
  std::minstd_rand random(static_cast<unsigned>(index + 1));
  const auto noise = [&random] { return 1e-3 * static_cast<double>(random()) / std::minstd_rand::max(); };
  const auto fill = [&](auto& values, double size) {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      values.data()[i] = size * (std::sin(0.01 * static_cast<double>(i) + s.time) + noise());
    }
  };
  const auto elements = static_cast<Eigen::Index>(structure.elements.size());
  s.positions.resize(3, structure.node_count);
  s.velocities.resize(3, structure.node_count);
  s.gradients.resize(3, structure.gradient_count);
  s.tension.resize(elements);
  s.strain.resize(elements);
  fill(s.positions, 7);
  fill(s.velocities, 0.5);
  fill(s.gradients, 1);
  fill(s.tension, 30);
  fill(s.strain, 1e-4);
  s.rope_element_length = {1.4 - 0.001 * index, 1.3 - 0.001 * index};
  for (std::size_t b = 0; b < structure.bodies.size(); ++b) {
    BodyState body;
    body.position = {0.1 * index, static_cast<double>(b), 1.0 / 3};
    body.attitude = Eigen::AngleAxisd(0.01 * index + static_cast<double>(b), Eigen::Vector3d::UnitY());
    body.velocity = {0.1, 0.2, 0.3};
    body.angular_velocity = {index * 0.01, 0, -1};
    s.bodies.push_back(body);
  }
  for (int c = 0; c < index % 5; ++c) {
    s.contacts.push_back({Eigen::Vector3d(c, index, 0.5), Eigen::Vector3d(0, -c, 2.5), c, 1});
  }
  for (std::size_t c = 0; c < s.channels.size(); ++c) s.channels[c] = std::sqrt(static_cast<double>(c + 1)) * index;
  s.channel(Channel::time) = s.time;
  return s;
}

Checkpoint synthetic_checkpoint(int index, int size) {
  Checkpoint checkpoint;
  checkpoint.time = index;
  for (int i = 0; i < size; ++i) checkpoint.state.push_back(std::sin(i) + index);
  if (index % 2 == 1) checkpoint.strategy = "name = \"faster\"\n";
  return checkpoint;
}

RunOrigin synthetic_origin() {
  RunOrigin origin;
  origin.scenario_name = "case1";
  origin.scenario_text = "name = \"case1\"  # 10 s, \xc2\xb5 = 0.4\n";
  origin.netpocket_version = "0.1.0";
  origin.commit = "abc1234";
  origin.command = "netpocket run case1.toml";
  origin.seed = 7;
  origin.threads = 2;
  origin.phases = pocket_phases(0, 10, 12.5);
  return origin;
}

void write_synthetic_run(const std::string& path, int frames, int elements, int checkpoint_size) {
  const Structure structure = synthetic_structure(elements);
  Recorder recorder(path, synthetic_origin(), structure, true);
  for (int i = 0; i < frames; ++i) {
    recorder.write(synthetic_frame(structure, i));
    if (i % 50 == 0) recorder.write(synthetic_checkpoint(i / 50, checkpoint_size));
  }
  RunStatistics statistics;
  statistics.simulated_seconds = 0.02 * (frames - 1);
  statistics.wall_seconds = 1.5;
  statistics.cpu_seconds = 1.25;
  statistics.steps = 123456789012;
  statistics.elements = elements;
  statistics.coordinates = 6 * elements;
  statistics.time_step = 1e-4;
  statistics.step_limit = "axial wave in panel 3 row 2";
  statistics.evaluation = "mean_strain";
  recorder.finish({RunReason::finished, statistics.simulated_seconds, "The run is complete."}, statistics);
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "netpocket-XXXXXX").string();
  path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

}  // namespace netpocket
