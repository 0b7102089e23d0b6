#include "engine/recording/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "engine/recording/checkpoint_io.h"
#include "engine/recording/hdf5_input.h"
#include "engine/recording/layout.h"
#include "engine/recording/origin_io.h"
#include "engine/recording/outcome_io.h"
#include "engine/recording/structure_io.h"
#include "engine/state/phase.h"

namespace netpocket {

namespace {

// Checks the format and returns its version.
std::int32_t check_format(const InputFile& file) {
  std::string format;
  try {
    format = file.read_text_attribute("/", "format");
  } catch (const Hdf5Error&) {
    // An HDF5 file of some other program.
  }
  if (format != layout::kFormat) throw Hdf5Error("it is not a Netpocket recording");
  const std::int32_t version = file.read_count_attribute("/", "format_version");
  if (version != layout::kVersion && version != layout::kVersionWithKinds) {
    throw Hdf5Error(fmt::format("its format is version {}, this program reads versions {} and {}", version,
                                layout::kVersionWithKinds, layout::kVersion));
  }
  return version;
}

std::vector<std::string> divided(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// Earlier versions of this program stored only names and units.
std::vector<std::string> read_optional_list(const InputFile& file, const char* name, char separator) {
  constexpr const char* kChannels = "/frames/channels";
  if (!file.has_attribute(kChannels, name)) return {};
  return divided(file.read_text_attribute(kChannels, name), separator);
}

// Information on a channel for which the file has only its name.
ChannelInfo known_info(const std::string& name) {
  const auto index = known_channels()->find(name);
  return index ? (*known_channels())[*index] : ChannelInfo{name, "", "", ChannelKind::value};
}

std::shared_ptr<const ChannelList> read_channel_list(const InputFile& file) {
  const auto names = divided(file.read_text_attribute("/frames/channels", "names"), ',');
  const auto units = read_optional_list(file, "units", ',');
  const auto kinds = read_optional_list(file, "kinds", ',');
  const auto meanings = read_optional_list(file, "meanings", '\n');
  std::vector<ChannelInfo> channels;
  for (std::size_t i = 0; i < names.size(); ++i) {
    ChannelInfo info = known_info(names[i]);
    if (i < units.size()) info.unit = units[i];
    if (i < kinds.size()) info.kind = channel_kind(kinds[i]).value_or(info.kind);
    if (i < meanings.size()) info.meaning = meanings[i];
    channels.push_back(std::move(info));
  }
  try {
    return std::make_shared<const ChannelList>(std::move(channels));
  } catch (const std::invalid_argument& error) {
    throw Hdf5Error(error.what());
  }
}

BodyState body_state(const double* n) {
  BodyState body;
  body.position = {n[0], n[1], n[2]};
  body.attitude = Eigen::Quaterniond(n[3], n[4], n[5], n[6]);
  body.velocity = {n[7], n[8], n[9]};
  body.angular_velocity = {n[10], n[11], n[12]};
  return body;
}

// The tables of frames that FORMAT.md lists. Tables without columns are absent.
struct Tables {
  Tables(const InputFile& file, const Structure& structure);
  void check_rows(std::size_t frames) const;

  InputTable position, velocity, gradient, tension, strain, rope, body, step, contact_range;
  InputTable contact_position, contact_force, contact_element, contact_body;
};

Tables::Tables(const InputFile& file, const Structure& structure) {
  const auto open = [&](InputTable& table, const char* path, H5T_class_t type, const std::vector<hsize_t>& shape) {
    const bool has_columns = shape.empty() || shape[0] > 0;
    if (has_columns) table = InputTable(file, path, type, shape);
  };
  const auto nodes = static_cast<hsize_t>(structure.node_count);
  const auto gradients = static_cast<hsize_t>(structure.gradient_count);
  const hsize_t elements = structure.elements.size();
  open(position, "/frames/position", H5T_FLOAT, {nodes, 3});
  open(velocity, "/frames/velocity", H5T_FLOAT, {nodes, 3});
  open(gradient, "/frames/gradient", H5T_FLOAT, {gradients, 3});
  open(tension, "/frames/tension", H5T_FLOAT, {elements});
  open(strain, "/frames/strain", H5T_FLOAT, {elements});
  open(rope, "/frames/rope_element_length", H5T_FLOAT, {static_cast<hsize_t>(structure.rope_count)});
  open(body, "/frames/body_state", H5T_FLOAT, {structure.bodies.size(), layout::kBodyNumbers});
  open(step, "/frames/step", H5T_INTEGER, {});
  open(contact_range, "/frames/contact_range", H5T_INTEGER, {2});
  open(contact_position, "/contacts/position", H5T_FLOAT, {3});
  open(contact_force, "/contacts/force", H5T_FLOAT, {3});
  open(contact_element, "/contacts/element", H5T_INTEGER, {});
  open(contact_body, "/contacts/body", H5T_INTEGER, {});
}

void Tables::check_rows(std::size_t frames) const {
  for (const InputTable* table :
       {&position, &velocity, &gradient, &tension, &strain, &rope, &body, &step, &contact_range}) {
    if (table->is_open() && table->row_count() < frames) throw Hdf5Error("some of its frames are incomplete");
  }
}

std::string refusal(const std::string& path, const std::string& reason) {
  return fmt::format("cannot read \"{}\": {}", path, reason);
}

}  // namespace

struct Recording::Impl {
  explicit Impl(const std::string& file_path) : path(file_path), file(file_path) {}

  void open();
  void read_channels();
  void complete_outcome();
  Snapshot read_frame(std::size_t index) const;
  void read_nodes(std::size_t index, Snapshot& snapshot) const;
  std::vector<ContactPoint> read_contacts(std::size_t index) const;

  std::string path;
  InputFile file;
  RunOrigin origin;
  Structure structure;
  Outcome outcome;
  std::optional<Tables> tables;
  std::optional<CheckpointReader> checkpoints;
  const std::vector<double>& times() const { return channels[channel_list->find(Channel::time).value()]; }
  std::shared_ptr<const ChannelList> channel_list;
  std::vector<std::vector<double>> channels;  // in the order of channel_list
  std::vector<double> not_recorded;           // NaN, by frame
};

void Recording::Impl::open() {
  const std::int32_t version = check_format(file);
  origin = read_origin(file);
  structure = read_structure(file, version);
  read_channels();
  structure.channels = channel_list;
  // Phases that begin with events were not known when the run began.
  if (const auto phase = channel_list->find(kPhaseChannel))
    origin.phases = phases_of_channel(times(), channels[*phase]);
  tables.emplace(file, structure);
  tables->check_rows(times().size());
  checkpoints.emplace(file);
  complete_outcome();
}

// The channels are read before the other tables. While another program adds frames, the other tables are complete up to
// the last row of channels. Rows that a killed program announced but did not write have the time NaN.
void Recording::Impl::read_channels() {
  channel_list = read_channel_list(file);
  const std::size_t columns = channel_list->size();
  const InputTable table(file, "/frames/channels", H5T_FLOAT, {columns});
  const auto values = table.read_announced();
  const std::size_t rows = values.size() / columns;
  const std::size_t time = channel_list->find(Channel::time).value();
  std::size_t frames = 0;
  while (frames < rows && std::isfinite(values[frames * columns + time])) ++frames;
  channels.resize(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    channels[c].resize(frames);
    for (std::size_t i = 0; i < frames; ++i) channels[c][i] = values[i * columns + c];
  }
  not_recorded.assign(frames, std::numeric_limits<double>::quiet_NaN());
  if (!std::is_sorted(times().begin(), times().end())) throw Hdf5Error("its frames are out of order");
}

void Recording::Impl::complete_outcome() {
  const std::vector<double>& times = this->times();
  if (auto stored = read_outcome(file)) {
    outcome = std::move(*stored);
    return;
  }
  outcome.status.time = times.empty() ? 0 : times.back();
  outcome.status.message = "the run was cut off, or is still going on";
  outcome.statistics.simulated_seconds = outcome.status.time;
  outcome.statistics.elements = static_cast<std::int32_t>(structure.elements.size());
  outcome.statistics.steps = times.empty() ? 0 : tables->step.read<std::int64_t>(times.size() - 1, 1)[0];
}

Snapshot Recording::Impl::read_frame(std::size_t index) const {
  Snapshot snapshot;
  snapshot.channel_list = channel_list;
  snapshot.channels.resize(channels.size());
  for (std::size_t c = 0; c < channels.size(); ++c) snapshot.channels[c] = channels[c][index];
  snapshot.time = times()[index];
  snapshot.step = tables->step.read<std::int64_t>(index, 1)[0];
  read_nodes(index, snapshot);
  if (tables->rope.is_open()) snapshot.rope_element_length = tables->rope.read<double>(index, 1);
  if (tables->body.is_open()) {
    const auto numbers = tables->body.read<double>(index, 1);
    for (std::size_t i = 0; i < numbers.size(); i += layout::kBodyNumbers) {
      snapshot.bodies.push_back(body_state(numbers.data() + i));
    }
  }
  snapshot.contacts = read_contacts(index);
  return snapshot;
}

void Recording::Impl::read_nodes(std::size_t index, Snapshot& snapshot) const {
  const auto matrix = [index](const InputTable& table) -> Eigen::Matrix3Xd {
    if (!table.is_open()) return Eigen::Matrix3Xd(3, 0);
    const auto values = table.read<double>(index, 1);
    return Eigen::Map<const Eigen::Matrix3Xd>(values.data(), 3, static_cast<Eigen::Index>(values.size() / 3));
  };
  const auto vector = [index](const InputTable& table) -> Eigen::VectorXd {
    if (!table.is_open()) return Eigen::VectorXd(0);
    const auto values = table.read<double>(index, 1);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  };
  snapshot.positions = matrix(tables->position);
  snapshot.velocities = matrix(tables->velocity);
  snapshot.gradients = matrix(tables->gradient);
  snapshot.tension = vector(tables->tension);
  snapshot.strain = vector(tables->strain);
}

std::vector<ContactPoint> Recording::Impl::read_contacts(std::size_t index) const {
  std::vector<ContactPoint> contacts;
  const auto range = tables->contact_range.read<std::int64_t>(index, 1);
  if (range[0] < 0 || range[1] < 0) throw Hdf5Error("its contacts are damaged");
  const auto first = static_cast<hsize_t>(range[0]);
  const auto count = static_cast<hsize_t>(range[1]);
  const auto positions = tables->contact_position.read<double>(first, count);
  const auto forces = tables->contact_force.read<double>(first, count);
  const auto elements = tables->contact_element.read<std::int32_t>(first, count);
  const auto bodies = tables->contact_body.read<std::int32_t>(first, count);
  for (std::size_t i = 0; i < count; ++i) {
    const ContactPoint contact = {Eigen::Vector3d(positions.data() + 3 * i), Eigen::Vector3d(forces.data() + 3 * i),
                                  elements[i], bodies[i]};
    const bool valid = contact.element >= -1 && contact.body >= 0 &&
                       contact.element < static_cast<std::int64_t>(structure.elements.size()) &&
                       static_cast<std::size_t>(contact.body) < structure.bodies.size();
    if (!valid) throw Hdf5Error("its contacts are damaged");
    contacts.push_back(contact);
  }
  return contacts;
}

Recording::Recording(const std::string& path) {
  silence_hdf5();
  try {
    impl_ = std::make_unique<Impl>(path);
    impl_->open();
  } catch (const Hdf5Error& error) {
    throw RecordingError(refusal(path, error.what()));
  } catch (const std::bad_alloc&) {
    throw RecordingError(refusal(path, "it does not fit in memory"));
  }
}

Recording::~Recording() = default;
Recording::Recording(Recording&&) noexcept = default;
Recording& Recording::operator=(Recording&&) noexcept = default;

const std::string& Recording::path() const { return impl_->path; }
const RunOrigin& Recording::origin() const { return impl_->origin; }
const Structure& Recording::structure() const { return impl_->structure; }
const RunStatus& Recording::status() const { return impl_->outcome.status; }
const RunStatistics& Recording::statistics() const { return impl_->outcome.statistics; }
const std::vector<double>& Recording::times() const { return impl_->times(); }

const std::shared_ptr<const ChannelList>& Recording::channels() const { return impl_->channel_list; }

const std::vector<double>& Recording::channel(std::size_t index) const { return impl_->channels.at(index); }

const std::vector<double>& Recording::channel(Channel c) const {
  const auto index = impl_->channel_list->find(c);
  return index ? impl_->channels[*index] : impl_->not_recorded;
}

// Returns the result of `read` for an existing frame.
template <typename Read>
static auto checked_frame(const Recording& recording, std::size_t index, const Read& read) {
  if (index >= recording.frame_count()) {
    throw RecordingError(
        refusal(recording.path(), fmt::format("it has no frame {}, only {}", index, recording.frame_count())));
  }
  silence_hdf5();
  try {
    return read();
  } catch (const Hdf5Error& error) {
    throw RecordingError(refusal(recording.path(), error.what()));
  }
}

Snapshot Recording::frame(std::size_t index) const {
  return checked_frame(*this, index, [&] { return impl_->read_frame(index); });
}

std::vector<ContactPoint> Recording::contacts(std::size_t index) const {
  return checked_frame(*this, index, [&] { return impl_->read_contacts(index); });
}

const std::vector<double>& Recording::checkpoint_times() const { return impl_->checkpoints->times(); }

bool Recording::changes_strategy(std::size_t checkpoint) const {
  return checkpoint < checkpoint_times().size() && impl_->checkpoints->changes_strategy(checkpoint);
}

Checkpoint Recording::checkpoint(std::size_t index) const {
  if (index >= checkpoint_times().size()) {
    throw RecordingError(refusal(path(), fmt::format("it has no checkpoint {}", index)));
  }
  silence_hdf5();
  try {
    return impl_->checkpoints->read(index);
  } catch (const Hdf5Error& error) {
    throw RecordingError(refusal(path(), error.what()));
  }
}

std::size_t Recording::frame_at(double time) const {
  const auto& t = times();
  if (t.empty()) throw RecordingError(refusal(path(), "it has no frame"));
  const auto after = std::lower_bound(t.begin(), t.end(), time);
  if (after == t.begin()) return 0;
  if (after == t.end()) return t.size() - 1;
  const bool earlier_is_nearer = time - *(after - 1) <= *after - time;
  return static_cast<std::size_t>(after - t.begin()) - (earlier_is_nearer ? 1 : 0);
}

}  // namespace netpocket
