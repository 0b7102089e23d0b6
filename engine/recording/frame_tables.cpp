#include "engine/recording/frame_tables.h"

#include <fmt/format.h>

#include "engine/recording/layout.h"

namespace netpocket {

namespace {

constexpr hsize_t kSmallRowsPerChunk = 64;
constexpr hsize_t kContactsPerChunk = 1024;

void create(std::optional<OutputTable>& table, const Handle& group, hid_t type, const TableLayout& layout,
            ChunkCodec& codec) {
  const bool has_columns = layout.shape.empty() || layout.shape[0] > 0;
  if (has_columns) table.emplace(group.get(), type, layout, codec);
}

}  // namespace

FrameTables::FrameTables(hid_t file, const Structure& structure, ChunkCodec& codec)
    : frames_(create_group(file, "/frames")), contacts_(create_group(file, "/contacts")) {
  create_large_tables(structure, codec);
  create_small_tables(structure, codec);
  create_contact_tables(codec);
  describe_channels(*structure.channels);
}

void FrameTables::create_large_tables(const Structure& structure, ChunkCodec& codec) {
  const auto nodes = static_cast<hsize_t>(structure.node_count);
  const auto gradients = static_cast<hsize_t>(structure.gradient_count);
  const hsize_t elements = structure.elements.size();
  const hid_t type = H5T_NATIVE_FLOAT;
  create(position_, frames_, type, {"position", "m", "of each node, world axes", {nodes, 3}}, codec);
  create(velocity_, frames_, type, {"velocity", "m/s", "of each node, world axes", {nodes, 3}}, codec);
  create(gradient_, frames_, type, {"gradient", "1", "dr/dp, world axes", {gradients, 3}}, codec);
  create(tension_, frames_, type, {"tension", "N", "of each element, negative in compression", {elements}}, codec);
  create(strain_, frames_, type, {"strain", "1", "Green strain of each element", {elements}}, codec);
}

void FrameTables::create_small_tables(const Structure& structure, ChunkCodec& codec) {
  const auto ropes = static_cast<hsize_t>(structure.rope_count);
  const hsize_t bodies = structure.bodies.size();
  const hsize_t rows = kSmallRowsPerChunk;
  const hid_t real = H5T_NATIVE_DOUBLE;
  const hid_t integer = H5T_NATIVE_INT64;
  create(rope_, frames_, real,
         {"rope_element_length", "m", "material length of one element of each rope", {ropes}, rows}, codec);
  create(body_, frames_, real,
         {"body_state",
          "m, 1, m/s, rad/s",
          "centre of mass, attitude quaternion w x y z (body to world), velocity, angular velocity; world axes",
          {bodies, layout::kBodyNumbers},
          rows},
         codec);
  create(step_, frames_, integer, {"step", "1", "integration steps so far", {}, rows}, codec);
  create(contact_range_, frames_, integer,
         {"contact_range", "", "first row in /contacts and number of rows", {2}, rows}, codec);
  create(channels_, frames_, real,
         {"channels",
          "see units",
          "scalars; attributes names, units, kinds and meanings say what the columns are",
          {structure.channels->size()},
          rows},
         codec);
}

void FrameTables::create_contact_tables(ChunkCodec& codec) {
  const hsize_t rows = kContactsPerChunk;
  create(contact_position_, contacts_, H5T_NATIVE_FLOAT, {"position", "m", "on the body, world axes", {3}, rows},
         codec);
  create(contact_force_, contacts_, H5T_NATIVE_FLOAT, {"force", "N", "on the body, world axes", {3}, rows}, codec);
  create(contact_element_, contacts_, H5T_NATIVE_INT32,
         {"element", "", "row of structure/element_*; -1: another body touches", {}, rows}, codec);
  create(contact_body_, contacts_, H5T_NATIVE_INT32, {"body", "", "row of structure/body_*", {}, rows}, codec);
}

void FrameTables::describe_channels(const ChannelList& channels) {
  std::vector<std::string> names, units, kinds, meanings;
  for (const ChannelInfo& channel : channels) {
    names.push_back(channel.name);
    units.push_back(channel.unit);
    kinds.emplace_back(to_string(channel.kind));
    meanings.push_back(channel.meaning);
  }
  write_attribute(channels_->dataset(), "names", fmt::format("{}", fmt::join(names, ",")));
  write_attribute(channels_->dataset(), "units", fmt::format("{}", fmt::join(units, ",")));
  write_attribute(channels_->dataset(), "kinds", fmt::format("{}", fmt::join(kinds, ",")));
  write_attribute(channels_->dataset(), "meanings", fmt::format("{}", fmt::join(meanings, "\n")));
}

template <typename Matrix>
void FrameTables::append_single(std::optional<OutputTable>& table, const Matrix& values) {
  if (!table) return;
  single_.resize(static_cast<std::size_t>(values.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    single_[static_cast<std::size_t>(i)] = static_cast<float>(values.data()[i]);
  }
  table->append(std::span<const float>(single_));
}

void FrameTables::append_bodies(const std::vector<BodyState>& bodies) {
  for (const BodyState& body : bodies) {
    const Eigen::Vector3d& r = body.position;
    const Eigen::Quaterniond& q = body.attitude;
    const Eigen::Vector3d& v = body.velocity;
    const Eigen::Vector3d& w = body.angular_velocity;
    const std::array<double, layout::kBodyNumbers> numbers = {r.x(), r.y(), r.z(), q.w(), q.x(), q.y(), q.z(),
                                                              v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
    body_->append(std::span<const double>(numbers));
  }
}

void FrameTables::append_contacts(const std::vector<ContactPoint>& contacts) {
  const std::array<std::int64_t, 2> range = {static_cast<std::int64_t>(contact_body_->row_count()),
                                             static_cast<std::int64_t>(contacts.size())};
  contact_range_->append(std::span<const std::int64_t>(range));
  for (const ContactPoint& contact : contacts) {
    const Eigen::Vector3f position = contact.position.cast<float>();
    const Eigen::Vector3f force = contact.force.cast<float>();
    contact_position_->append(std::span<const float>(position.data(), 3));
    contact_force_->append(std::span<const float>(force.data(), 3));
    contact_element_->append(std::span<const std::int32_t>(&contact.element, 1));
    contact_body_->append(std::span<const std::int32_t>(&contact.body, 1));
  }
}

void FrameTables::append(const Snapshot& snapshot) {
  append_single(position_, snapshot.positions);
  append_single(velocity_, snapshot.velocities);
  append_single(gradient_, snapshot.gradients);
  append_single(tension_, snapshot.tension);
  append_single(strain_, snapshot.strain);
  for (auto* large : {&position_, &velocity_, &gradient_, &tension_, &strain_}) {
    if (*large) (*large)->store();
  }
  if (rope_) rope_->append(std::span<const double>(snapshot.rope_element_length));
  append_bodies(snapshot.bodies);
  append_contacts(snapshot.contacts);
  step_->append(std::span<const std::int64_t>(&snapshot.step, 1));
  std::vector<double> channels = snapshot.channels;
  channels[snapshot.channel_list->find(Channel::time).value()] = snapshot.time;
  channels_->append(std::span<const double>(channels));
}

void FrameTables::store_frames() {
  for (auto* table : {&rope_, &body_, &step_, &contact_range_, &contact_position_, &contact_force_, &contact_element_,
                      &contact_body_}) {
    if (*table) (*table)->store();
  }
}

void FrameTables::store_channels() { channels_->store(); }

}  // namespace netpocket
