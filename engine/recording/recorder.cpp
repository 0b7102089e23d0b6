#include "engine/recording/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/recording/checkpoint_io.h"
#include "engine/recording/frame_tables.h"
#include "engine/recording/layout.h"
#include "engine/recording/origin_io.h"
#include "engine/recording/outcome_io.h"
#include "engine/recording/output_file.h"
#include "engine/recording/structure_io.h"

namespace netpocket {

namespace {

using Clock = std::chrono::steady_clock;
// Less than a second together with the duration of a flush, which waits for the disk four times.
constexpr std::chrono::milliseconds kFlushInterval(500);
constexpr const char* kFinished = "the recording is finished";

Handle create_file(const std::string& path) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe file access");
  // The newest format of HDF5 1.10. All its metadata has checksums, and it supports SWMR.
  checked(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the file format");
  checked(H5Pset_file_locking(access.get(), false, true), "describe file access");  // OutputFile holds the lock
  // Bytes. Metadata must not cross pages of the disk: a loss of power may store one page and not the next.
  constexpr hsize_t kPage = 1024;
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "describe the file");
  checked(H5Pset_file_space_strategy(creation.get(), H5F_FSPACE_STRATEGY_PAGE, false, 1), "describe the file");
  checked(H5Pset_file_space_page_size(creation.get(), kPage), "describe the file");
  return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose, "create the file");
}

}  // namespace

struct Recorder::Impl {
  Impl(const std::string& path, bool overwrite) : output(path, overwrite) {}
  ~Impl() { close(); }

  void create(const RunOrigin& origin, const Structure& structure);
  void check_sizes(const Snapshot& snapshot) const;
  void check_order(const Snapshot& snapshot) const;
  void check_numbers(const Snapshot& snapshot) const;
  void write(const Snapshot& snapshot);
  void write(const Checkpoint& checkpoint);
  void store();
  void flush();
  void make_safe();
  bool close_file();
  void finish(const RunStatus& status, const RunStatistics& statistics);
  void close();
  void ensure_room();
  void require_open() const;
  // Runs an action on the file. If it fails, the recording ends.
  template <typename Action>
  void guarded(const Action& action);

  OutputFile output;
  ChunkCodec codec;
  Handle file;  // declared before the tables, so that it is closed after them
  std::optional<FrameTables> frames;
  std::optional<CheckpointTables> checkpoints;
  std::optional<OutcomeTables> outcome;
  Structure structure;
  Clock::time_point last_flush = Clock::now();
  double last_time = 0;
  double last_checkpoint_time = 0;
  std::size_t frame_count = 0;
  std::size_t published_from = 1;  // number of frames from which the recording has its final name
  std::string refusal;             // why nothing more can be written; empty: it can
};

void Recorder::Impl::require_open() const {
  if (!refusal.empty()) throw write_error(output.path(), refusal);
}

// Any failure ends the recording: the system reports a page that it could not write only once and then forgets it.
template <typename Action>
void Recorder::Impl::guarded(const Action& action) {
  silence_hdf5();
  require_open();
  const std::string before = std::exchange(refusal, "an earlier write failed");
  try {
    action();
  } catch (const Hdf5Error& error) {
    throw write_error(output.path(), fmt::format("failed to {}", error.what()));
  }
  refusal = before;
}

void Recorder::Impl::create(const RunOrigin& origin, const Structure& model) {
  structure = model;
  file = create_file(output.working_path());
  output.ensure_room(0);
  write_attribute(file.get(), "format", std::string(layout::kFormat));
  write_attribute(file.get(), "format_version", std::int64_t{layout::kVersion});
  write_origin(file.get(), origin, codec);
  write_structure(file.get(), structure, codec);
  frames.emplace(file.get(), structure, codec);
  checkpoints.emplace(file.get(), codec);
  outcome.emplace(file.get(), codec);
  // From here on every write keeps the file readable, whenever the program dies (HDF5's mode "single writer, multiple
  // readers"). In return, no dataset or attribute can be added any more.
  checked(H5Fstart_swmr_write(file.get()), "make the file safe against crashes");
}

void Recorder::Impl::ensure_room() {
  hsize_t size = 0;
  guarded([&] { checked(H5Fget_filesize(file.get(), &size), "find the file's size"); });
  output.ensure_room(size);
}

void Recorder::Impl::check_sizes(const Snapshot& snapshot) const {
  const auto elements = static_cast<Eigen::Index>(structure.elements.size());
  const bool fits = snapshot.positions.cols() == structure.node_count &&
                    snapshot.velocities.cols() == structure.node_count &&
                    snapshot.gradients.cols() == structure.gradient_count && snapshot.tension.size() == elements &&
                    snapshot.strain.size() == elements &&
                    snapshot.rope_element_length.size() == static_cast<std::size_t>(structure.rope_count) &&
                    snapshot.bodies.size() == structure.bodies.size() &&
                    (snapshot.channel_list == structure.channels ||
                     std::ranges::equal(*snapshot.channel_list, *structure.channels)) &&
                    snapshot.channels.size() == structure.channels->size();
  if (!fits) throw RecordingError(fmt::format("cannot write \"{}\": a frame does not fit the model", output.path()));
}

void Recorder::Impl::check_order(const Snapshot& snapshot) const {
  if (!std::isfinite(snapshot.time) || (frame_count > 0 && snapshot.time < last_time)) {
    throw RecordingError(
        fmt::format("cannot write \"{}\": frames are out of order at t = {} s", output.path(), snapshot.time));
  }
}

// Numbers are stored in single precision. Those beyond its range would become infinite.
void Recorder::Impl::check_numbers(const Snapshot& snapshot) const {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const auto is_storable = [](const auto& values) {
    return values.size() == 0 || (values.allFinite() && values.cwiseAbs().maxCoeff() < kLargest);
  };
  bool storable = true;
  for (const Eigen::Matrix3Xd* m : {&snapshot.positions, &snapshot.velocities, &snapshot.gradients}) {
    storable = storable && is_storable(*m);
  }
  storable = storable && is_storable(snapshot.tension) && is_storable(snapshot.strain);
  for (const BodyState& body : snapshot.bodies) {
    storable = storable && body.position.allFinite() && body.attitude.coeffs().allFinite() &&
               body.velocity.allFinite() && body.angular_velocity.allFinite();
  }
  for (const ContactPoint& contact : snapshot.contacts) {
    storable = storable && is_storable(contact.position) && is_storable(contact.force);
  }
  const Eigen::Map<const Eigen::VectorXd> channels(snapshot.channels.data(),
                                                   static_cast<Eigen::Index>(snapshot.channels.size()));
  if (!storable || !channels.allFinite()) {
    throw RecordingError(fmt::format("cannot write \"{}\": the frame at t = {} s holds numbers that are not finite",
                                     output.path(), snapshot.time));
  }
}

// Errors found before the file is touched do not end the recording.
void Recorder::Impl::write(const Snapshot& snapshot) {
  require_open();
  check_sizes(snapshot);
  check_order(snapshot);
  check_numbers(snapshot);
  ensure_room();
  guarded([&] {
    output.require_whole();  // checked first, because writing more would hide it
    frames->append(snapshot);
    last_time = snapshot.time;
    ++frame_count;
  });
  if (frame_count == 1 || Clock::now() - last_flush >= kFlushInterval) flush();
}

void Recorder::Impl::write(const Checkpoint& checkpoint) {
  require_open();
  if (!std::isfinite(checkpoint.time) || checkpoint.time < last_checkpoint_time) {
    throw RecordingError(
        fmt::format("cannot write \"{}\": checkpoints are out of order at t = {} s", output.path(), checkpoint.time));
  }
  guarded([&] {
    output.require_whole();
    checkpoints->append(checkpoint);
  });
  last_checkpoint_time = checkpoint.time;
}

// Puts all frames and checkpoints so far into the file and on the disk.
void Recorder::Impl::store() {
  require_open();
  if (frame_count == 0) return;
  guarded([this] {
    output.require_whole();
    frames->store_frames();
    checkpoints->store_states();
    make_safe();
    frames->store_channels();
    checkpoints->store_times();
    make_safe();
  });
  if (frame_count >= published_from) output.publish();
  last_flush = Clock::now();
}

void Recorder::Impl::flush() {
  store();
  output.require_name();
}

// Chunks are on the disk before the indexes that refer to them, so no index on the disk refers to missing data.
void Recorder::Impl::make_safe() {
  output.sync();
  checked(H5Fflush(file.get(), H5F_SCOPE_LOCAL), "flush the file");
  output.sync();
}

void Recorder::Impl::finish(const RunStatus& status, const RunStatistics& statistics) {
  store();
  guarded([&] {
    outcome->write(file.get(), status, statistics);
    if (!close_file()) throw Hdf5Error("close the file");
    output.sync();
  });
  refusal = kFinished;
  const bool found = output.has_name();
  output.close();
  if (!found) output.fail_nameless();
}

bool Recorder::Impl::close_file() {
  frames.reset();
  checkpoints.reset();
  outcome.reset();
  return file.reset();
}

// For a recording without finish().
void Recorder::Impl::close() {
  silence_hdf5();
  try {
    if (refusal.empty() && frames) store();
  } catch (const std::exception&) {
    // The frames of the last flush are safe. A destructor cannot report more.
  }
  // HDF5 writes when it closes a file. After a failed write, new indexes could refer to data that never reached the
  // disk. The file is left as if the program had been killed here.
  if (!refusal.empty() && output.is_published()) file.abandon();
  close_file();
  output.close();
}

Recorder::Recorder(const std::string& path, const RunOrigin& origin, const Structure& structure, bool overwrite)
    : impl_(std::make_unique<Impl>(path, overwrite)) {
  const std::string fault = find_fault(structure);
  if (!fault.empty()) throw RecordingError(fmt::format("cannot record \"{}\": {}", path, fault));
  impl_->guarded([&] { impl_->create(origin, structure); });
}

Recorder::~Recorder() = default;

void Recorder::hold_back(std::size_t frame_count) { impl_->published_from = std::max<std::size_t>(1, frame_count); }

bool Recorder::is_published() const { return impl_->output.is_published(); }

void Recorder::write(const Snapshot& snapshot) { impl_->write(snapshot); }

void Recorder::write(const Checkpoint& checkpoint) { impl_->write(checkpoint); }

void Recorder::flush() { impl_->flush(); }

void Recorder::finish(const RunStatus& status, const RunStatistics& statistics) { impl_->finish(status, statistics); }

}  // namespace netpocket
