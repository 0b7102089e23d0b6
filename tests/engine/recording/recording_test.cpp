// What is recorded is read back; files are replaced only when they should be.
#include "engine/recording/recording.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <thread>

#include "engine/recording/background_recorder.h"
#include "tests/engine/recording/disk_log.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

// Node data are stored in single precision: half a unit in the last place.
constexpr double kSingle = 0.5 * std::numeric_limits<float>::epsilon();

template <typename Matrix>
void expect_single(const Matrix& found, const Matrix& expected) {
  ASSERT_EQ(found.cols(), expected.cols());
  ASSERT_EQ(found.rows(), expected.rows());
  for (Eigen::Index i = 0; i < found.size(); ++i) {
    ASSERT_NEAR(found.data()[i], expected.data()[i], kSingle * std::abs(expected.data()[i])) << i;
  }
}

void expect_same(const Snapshot& found, const Snapshot& expected) {
  EXPECT_EQ(found.time, expected.time);
  EXPECT_EQ(found.step, expected.step);
  EXPECT_EQ(found.channels, expected.channels);
  EXPECT_EQ(found.rope_element_length, expected.rope_element_length);
  expect_single(found.positions, expected.positions);
  expect_single(found.velocities, expected.velocities);
  expect_single(found.gradients, expected.gradients);
  expect_single(found.tension, expected.tension);
  expect_single(found.strain, expected.strain);
  ASSERT_EQ(found.bodies.size(), expected.bodies.size());
  for (std::size_t b = 0; b < found.bodies.size(); ++b) {
    EXPECT_EQ(found.bodies[b].position, expected.bodies[b].position);
    EXPECT_EQ(found.bodies[b].attitude.coeffs(), expected.bodies[b].attitude.coeffs());
    EXPECT_EQ(found.bodies[b].velocity, expected.bodies[b].velocity);
    EXPECT_EQ(found.bodies[b].angular_velocity, expected.bodies[b].angular_velocity);
  }
  ASSERT_EQ(found.contacts.size(), expected.contacts.size());
  for (std::size_t c = 0; c < found.contacts.size(); ++c) {
    EXPECT_EQ(found.contacts[c].position, expected.contacts[c].position);
    EXPECT_EQ(found.contacts[c].force, expected.contacts[c].force);
    EXPECT_EQ(found.contacts[c].element, expected.contacts[c].element);
    EXPECT_EQ(found.contacts[c].body, expected.contacts[c].body);
  }
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(Recording, KeepsEveryFrame) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 150, 500);
  const Recording recording(folder.file("run.h5"));
  ASSERT_EQ(recording.frame_count(), 150u);
  for (int i = 0; i < 150; ++i) {
    expect_same(recording.frame(static_cast<std::size_t>(i)), synthetic_frame(recording.structure(), i));
  }
}

TEST(Recording, KeepsTheControlLoops) {
  const TemporaryFolder folder;
  Structure structure = synthetic_structure(20);
  structure.loops = {
      {"Tow", "spacecraft", "speed", "controller.0", {"state"}, {"wanted"}, {"speed"}, {}, {"f_x", "f_y"}},
      {"Winch 1", "closing rope 1", "length", ""}};
  {
    Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
    recorder.write(synthetic_frame(structure, 0));
  }
  EXPECT_EQ(Recording(folder.file("run.h5")).structure().loops, structure.loops);
}

TEST(Recording, KeepsTheStructure) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 1, 20);
  const Structure found = Recording(folder.file("run.h5")).structure();
  const Structure expected = synthetic_structure(20);
  EXPECT_EQ(found.node_count, expected.node_count);
  EXPECT_EQ(found.gradient_count, expected.gradient_count);
  EXPECT_EQ(found.rope_count, expected.rope_count);
  EXPECT_EQ(found.threads, expected.threads);
  EXPECT_EQ(found.element_groups, expected.element_groups);
  EXPECT_EQ(found.node_groups, expected.node_groups);
  ASSERT_EQ(found.elements.size(), expected.elements.size());
  for (std::size_t i = 0; i < found.elements.size(); ++i) {
    const StructureElement& f = found.elements[i];
    const StructureElement& e = expected.elements[i];
    EXPECT_TRUE(std::equal(f.node, f.node + 2, e.node));
    EXPECT_TRUE(std::equal(f.gradient, f.gradient + 2, e.gradient));
    EXPECT_EQ(std::tie(f.group, f.thread, f.rope, f.length, f.radius),
              std::tie(e.group, e.thread, e.rope, e.length, e.radius));
  }
  ASSERT_EQ(found.bodies.size(), 3u);
  EXPECT_EQ(found.bodies[0].name, "spacecraft");
  EXPECT_EQ(found.bodies[1].role, BodyRole::target);
  EXPECT_EQ(found.bodies[1].mass, 200);
  EXPECT_EQ(std::get<Box>(found.bodies[0].shape).size, Eigen::Vector3d(1.6, 2.0, 1.6));
  EXPECT_EQ(std::get<Sphere>(found.bodies[1].shape).radius, 4.5);
  EXPECT_EQ(std::get<Cylinder>(found.bodies[2].shape).length, 1.5);
}

TEST(Recording, KeepsOriginAndOutcome) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 3);
  const Recording recording(folder.file("run.h5"));
  const RunOrigin expected = synthetic_origin();
  const RunOrigin& origin = recording.origin();
  EXPECT_EQ(origin.scenario_name, expected.scenario_name);
  EXPECT_EQ(origin.scenario_text, expected.scenario_text);
  EXPECT_EQ(origin.netpocket_version, expected.netpocket_version);
  EXPECT_EQ(origin.commit, expected.commit);
  EXPECT_EQ(origin.command, expected.command);
  EXPECT_EQ(origin.seed, 7);
  EXPECT_EQ(origin.threads, 2);
  EXPECT_EQ(origin.phases, pocket_phases(0, 10, 12.5));
  EXPECT_EQ(recording.status().reason, RunReason::finished);
  EXPECT_EQ(recording.status().message, "The run is complete.");
  EXPECT_EQ(recording.statistics().steps, 123456789012);
  EXPECT_EQ(recording.statistics().wall_seconds, 1.5);
  EXPECT_EQ(recording.statistics().step_limit, "axial wave in panel 3 row 2");
  EXPECT_EQ(recording.statistics().evaluation, "mean_strain");
}

TEST(Recording, TakesAModelWithoutRopesBodiesAndElements) {
  const TemporaryFolder folder;
  Structure structure;
  structure.node_count = 1;
  Snapshot snapshot;
  snapshot.positions = snapshot.velocities = Eigen::Matrix3Xd::Constant(3, 1, 0.5);
  snapshot.gradients.resize(3, 0);
  Recorder(folder.file("point.h5"), RunOrigin(), structure, false).write(snapshot);
  const Recording recording(folder.file("point.h5"));
  expect_same(recording.frame(0), snapshot);
  EXPECT_TRUE(std::isnan(phase_begin(recording.origin().phases, kTowing)));
  EXPECT_EQ(recording.origin().scenario_text, "");
}

// A run of another kind of system brings its own channels.
TEST(Recording, CarriesItsOwnChannels) {
  const TemporaryFolder folder;
  const std::string path = folder.file("own.h5");
  const auto list = std::make_shared<const ChannelList>(
      std::vector<ChannelInfo>{{"net_area", "m^2", "area of the net, seen along y", ChannelKind::value},
                               {"time", "s", "simulated time", ChannelKind::value},
                               {"reel_work", "J", "work of the reels so far", ChannelKind::total}});
  Structure structure = synthetic_structure(20);
  structure.channels = list;
  {
    Recorder recorder(path, synthetic_origin(), structure, false);
    for (int i = 0; i < 3; ++i) {
      Snapshot snapshot = synthetic_frame(structure, i);
      snapshot.channel_list = list;
      snapshot.channels = {1.5 * i, snapshot.time, -2.0 * i};
      recorder.write(snapshot);
    }
    Snapshot foreign = synthetic_frame(structure, 3);
    foreign.channel_list = known_channels();
    foreign.channels.assign(known_channels()->size(), 0.0);
    EXPECT_THROW(recorder.write(foreign), RecordingError);
    recorder.finish({}, {});
  }
  const Recording recording(path);
  ASSERT_TRUE(std::ranges::equal(*recording.channels(), *list));
  EXPECT_EQ(recording.channel(2), (std::vector<double>{0, -2, -4}));
  EXPECT_EQ(recording.frame(1).channels[0], 1.5);
  EXPECT_EQ(recording.times()[2], recording.frame(2).time);
  EXPECT_FALSE(recording.has_channel(Channel::contact_fy));
  EXPECT_TRUE(std::isnan(recording.frame(1).channel(Channel::contact_fy)));
}

TEST(Recording, FindsTheNearestFrame) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 11);
  const Recording recording(folder.file("run.h5"));
  EXPECT_EQ(recording.frame_at(-1), 0u);
  EXPECT_EQ(recording.frame_at(0.029), 1u);
  EXPECT_EQ(recording.frame_at(0.031), 2u);
  EXPECT_EQ(recording.frame_at(99), 10u);
  EXPECT_NE(message_of([&] { recording.frame(11); }), "");
}

TEST(Recording, CanBeReadWhileItIsWritten) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(20);
  Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
  for (int i = 0; i < 70; ++i) recorder.write(synthetic_frame(structure, i));
  recorder.flush();
  for (int i = 70; i < 80; ++i) recorder.write(synthetic_frame(structure, i));
  const Recording recording(folder.file("run.h5"));
  EXPECT_EQ(recording.frame_count(), 70u);
  EXPECT_EQ(recording.status().reason, RunReason::running);
  expect_same(recording.frame(69), synthetic_frame(structure, 69));
}

TEST(Recorder, WithoutFinishKeepsTheFrames) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(20);
  {
    Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
    for (int i = 0; i < 10; ++i) recorder.write(synthetic_frame(structure, i));
  }
  const Recording recording(folder.file("run.h5"));
  EXPECT_EQ(recording.frame_count(), 10u);
  EXPECT_EQ(recording.status().reason, RunReason::running);
  EXPECT_EQ(recording.statistics().steps, 900);
}

TEST(Recorder, RefusesAnExistingFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_bytes(path, "precious");
  const auto create = [&] { Recorder(path, synthetic_origin(), synthetic_structure(20), false); };
  EXPECT_EQ(message_of(create), "cannot write \"" + path + "\": it exists already");
  EXPECT_EQ(read_bytes(path), "precious");
}

TEST(Recorder, ReplacesAnExistingFileOnlyWithItsFirstFrame) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_synthetic_run(path, 5);
  const std::string old = read_bytes(path);
  const Structure structure = synthetic_structure(30);
  { const Recorder without_frame(path, synthetic_origin(), structure, true); }
  EXPECT_EQ(read_bytes(path), old);
  Recorder recorder(path, synthetic_origin(), structure, true);
  EXPECT_EQ(read_bytes(path), old);
  recorder.write(synthetic_frame(structure, 0));
  EXPECT_EQ(Recording(path).structure().elements.size(), 30u);
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(Recorder, LeavesNothingBehindWithoutAFrame) {
  const TemporaryFolder folder;
  { const Recorder recorder(folder.file("run.h5"), synthetic_origin(), synthetic_structure(20), false); }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Recorder, GivesBackTheRoomItReserved) {
  const TemporaryFolder folder;
  write_synthetic_run(folder.file("run.h5"), 5);
  struct stat status = {};
  ASSERT_EQ(stat(folder.file("run.h5").c_str(), &status), 0);
  EXPECT_LT(512 * status.st_blocks, status.st_size + (1 << 16));
}

// As when a write comes right after another program has cut the file.
TEST(Recorder, NoticesAFileThatWasCutAndGrewAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  const Structure structure = synthetic_structure(20);
  Recorder recorder(path, synthetic_origin(), structure, false);
  for (int i = 0; i < 20; ++i) recorder.write(synthetic_frame(structure, i));
  recorder.flush();
  const auto size = std::filesystem::file_size(path);
  std::filesystem::resize_file(path, size / 2);
  std::filesystem::resize_file(path, size);
  EXPECT_TRUE(message_of([&] {
                recorder.write(synthetic_frame(structure, 20));
              }).ends_with("has cut it short while it was being written"));
}

TEST(Recorder, TwoCannotWriteOneFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  const Structure structure = synthetic_structure(20);
  Recorder first(path, synthetic_origin(), structure, true);
  const auto second = [&] { Recorder(path, synthetic_origin(), structure, true); };
  EXPECT_EQ(message_of(second), "cannot write \"" + path + "\": another program is writing it");
  first.write(synthetic_frame(structure, 0));
  EXPECT_EQ(message_of(second), "cannot write \"" + path + "\": another program is writing it");
  first.finish({}, {});
  EXPECT_EQ(message_of(second), "");
}

// Between opening and locking another program may finish with the file and remove it.
TEST(Recorder, LocksTheFileThatHasTheName) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  const Structure structure = synthetic_structure(20);
  test::before_next_lock([&](int) { std::filesystem::remove(path + ".part"); });
  Recorder recorder(path, synthetic_origin(), structure, false);
  EXPECT_EQ(message_of([&] { Recorder(path, synthetic_origin(), structure, false); }),
            "cannot write \"" + path + "\": another program is writing it");
  recorder.write(synthetic_frame(structure, 0));
  EXPECT_EQ(Recording(path).frame_count(), 1u);
}

TEST(Recorder, LeavesTheWorkingFileOfSomebodyElse) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  write_bytes(path + ".part", "half of a download");
  EXPECT_NE(message_of([&] { Recorder(path, synthetic_origin(), synthetic_structure(20), false); }), "");
  EXPECT_EQ(read_bytes(path + ".part"), "half of a download");
}

// Frames of some 20 MB: three wait, not 32.
TEST(BackgroundRecorder, HoldsSoManyBytesAndNotMore) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(150000);
  const Snapshot frame = synthetic_frame(structure, 0);
  const auto bytes = static_cast<std::size_t>(frame.positions.size() + frame.velocities.size() +
                                              frame.gradients.size() + frame.tension.size() + frame.strain.size()) *
                     sizeof(double);
  const std::size_t most = kBackgroundBytes / bytes;
  ASSERT_LT(most, kBackgroundFrames / 4);
  BackgroundRecorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
  std::atomic<std::size_t> given = 0;
  std::jthread maker;
  {
    const test::HeldDisk held;
    maker = std::jthread([&] {
      for (std::size_t i = 0; i < most + 4; ++i, ++given) recorder.write(Snapshot(frame));
    });
    std::size_t before = 0;
    do {
      before = given;
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    } while (given != before);
    EXPECT_GE(given, 1u);
    EXPECT_LE(given, most + 1);  // one is being written
  }
  maker.join();
  recorder.finish({RunReason::finished, 0, ""}, {});
  EXPECT_EQ(Recording(folder.file("run.h5")).frame_count(), most + 4);
}

TEST(Recorder, WritesNothingAfterTheEnd) {
  const TemporaryFolder folder;
  const std::string path = folder.file("run.h5");
  const Structure structure = synthetic_structure(20);
  Recorder recorder(path, synthetic_origin(), structure, false);
  recorder.write(synthetic_frame(structure, 0));
  recorder.finish({}, {});
  EXPECT_EQ(message_of([&] { recorder.write(synthetic_frame(structure, 1)); }),
            "cannot write \"" + path + "\": the recording is finished");
}

TEST(Recorder, SaysWhyAFileCannotBeCreated) {
  const TemporaryFolder folder;
  const auto create = [](const std::string& path) {
    return message_of([&] { Recorder(path, synthetic_origin(), synthetic_structure(20), true); });
  };
  EXPECT_EQ(create(folder.file("missing/run.h5")),
            "cannot write \"" + folder.file("missing/run.h5") + "\": No such file or directory");
  EXPECT_EQ(create(folder.path().string()), "cannot write \"" + folder.path().string() + "\": it is a folder");
  // Not even root may create files here.
  EXPECT_NE(create("/proc/run.h5"), "");
}

TEST(Recorder, RefusesFramesThatDoNotFit) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(20);
  Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
  recorder.write(synthetic_frame(structure, 5));
  EXPECT_NE(message_of([&] { recorder.write(synthetic_frame(synthetic_structure(21), 6)); }), "");
  EXPECT_NE(message_of([&] { recorder.write(synthetic_frame(structure, 4)); }), "");
  Snapshot nonsense = synthetic_frame(structure, 7);
  nonsense.time = std::nan("");
  EXPECT_NE(message_of([&] { recorder.write(nonsense); }), "");
  recorder.write(synthetic_frame(structure, 6));
  recorder.finish({}, {});
  EXPECT_EQ(Recording(folder.file("run.h5")).frame_count(), 2u);
}

TEST(Recorder, RefusesAStructureWithInvalidIndices) {
  const TemporaryFolder folder;
  Structure structure = synthetic_structure(20);
  structure.elements[3].node[1] = 21;
  EXPECT_EQ(message_of([&] { Recorder(folder.file("run.h5"), synthetic_origin(), structure, false); }),
            "cannot record \"" + folder.file("run.h5") + "\": element 3 names a node that does not exist");
}

// Recording must cost little beside the integration. Processor time, because test machines are busy.
TEST(Recorder, CostsLessThanAMillisecondPerFrame) {
  const TemporaryFolder folder;
  const Structure structure = synthetic_structure(2000);
  std::vector<Snapshot> frames;
  for (int i = 0; i < 400; ++i) frames.push_back(synthetic_frame(structure, i));
  const std::clock_t start = std::clock();
  Recorder recorder(folder.file("run.h5"), synthetic_origin(), structure, false);
  for (const Snapshot& frame : frames) recorder.write(frame);
  recorder.finish({}, {});
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double per_frame = 1e3 * seconds / static_cast<double>(frames.size());
  const double bytes = static_cast<double>(std::filesystem::file_size(folder.file("run.h5")));
  std::printf("2000 elements: %.3f ms and %.1f kB per frame\n", per_frame, bytes / 1e3 / 400);
  RecordProperty("milliseconds_per_frame", std::to_string(per_frame));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(per_frame, 1.0);
#endif
}

}  // namespace
}  // namespace netpocket
