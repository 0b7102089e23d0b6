#include "tests/fuzz/recording_edits.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <iterator>
#include <numeric>
#include <vector>

namespace netpocket {
namespace {

constexpr const char* kTables[] = {"/scenario_name",
                                   "/scenario",
                                   "/command",
                                   "/structure/element_nodes",
                                   "/structure/element_gradients",
                                   "/structure/element_group",
                                   "/structure/element_thread",
                                   "/structure/element_rope",
                                   "/structure/element_length",
                                   "/structure/element_radius",
                                   "/structure/thread_names",
                                   "/structure/body_names",
                                   "/structure/body_role",
                                   "/structure/body_shape",
                                   "/structure/body_size",
                                   "/structure/body_mass",
                                   "/structure/group_look",
                                   "/structure/node_group_size",
                                   "/structure/node_group_nodes",
                                   "/frames/position",
                                   "/frames/velocity",
                                   "/frames/gradient",
                                   "/frames/tension",
                                   "/frames/strain",
                                   "/frames/rope_element_length",
                                   "/frames/body_state",
                                   "/frames/step",
                                   "/frames/contact_range",
                                   "/frames/channels",
                                   "/contacts/position",
                                   "/contacts/force",
                                   "/contacts/element",
                                   "/contacts/body",
                                   "/checkpoints/values",
                                   "/checkpoints/value_range",
                                   "/checkpoints/strategies",
                                   "/checkpoints/strategy_range",
                                   "/checkpoints/time",
                                   "/outcome/reason",
                                   "/outcome/message",
                                   "/outcome/time",
                                   "/outcome/steps",
                                   "/outcome/elements"};

struct AttributeName {
  const char* object;
  const char* name;
};
constexpr AttributeName kAttributes[] = {{"/", "format"},
                                         {"/", "format_version"},
                                         {"/", "netpocket_version"},
                                         {"/", "commit"},
                                         {"/", "seed"},
                                         {"/", "threads"},
                                         {"/structure", "node_count"},
                                         {"/structure", "gradient_count"},
                                         {"/structure", "rope_count"},
                                         {"/frames/channels", "names"}};

// Takes values off the front of the bytes; zeros when there are none left.
class Source {
 public:
  explicit Source(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  template <typename T>
  T take() {
    T value{};
    const std::size_t count = std::min(sizeof value, bytes_.size());
    std::memcpy(&value, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
    return value;
  }
  template <typename List>
  auto& pick(const List& list) {
    return list[take<std::uint8_t>() % std::size(list)];
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

hid_t pick_type(Source& source) {
  const std::array<hid_t, 5> types = {H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_INT64, H5T_NATIVE_UINT8,
                                      H5T_C_S1};
  return source.pick(types);
}

void replace_attribute(hid_t file, Source& source) {
  const AttributeName& which = source.pick(kAttributes);
  const hid_t type = pick_type(source);
  const auto value = source.take<std::int64_t>();
  const hid_t space = H5Screate(H5S_SCALAR);
  H5Adelete_by_name(file, which.object, which.name, H5P_DEFAULT);
  const hid_t attribute =
      H5Acreate_by_name(file, which.object, which.name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (attribute >= 0) {
    H5Awrite(attribute, type, &value);
    H5Aclose(attribute);
  }
  H5Sclose(space);
}

void remove_table(hid_t file, Source& source) { H5Ldelete(file, source.pick(kTables), H5P_DEFAULT); }

void replace_table(hid_t file, Source& source) {
  const char* path = source.pick(kTables);
  const hid_t type = pick_type(source);
  const int rank = 1 + source.take<std::uint8_t>() % 3;
  hsize_t size[3] = {}, chunk[3] = {1, 1, 1};
  for (int i = 0; i < rank; ++i) size[i] = source.take<std::uint32_t>();
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(properties, rank, chunk);
  const hid_t space = H5Screate_simple(rank, size, nullptr);
  H5Ldelete(file, path, H5P_DEFAULT);
  H5Dclose(H5Dcreate2(file, path, type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
  H5Sclose(space);
  H5Pclose(properties);
}

// Writes a number of either kind at a place of a table.
void write_number(hid_t table, hid_t space, double number, std::int64_t integer) {
  const hid_t type = H5Dget_type(table);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_STRING) {
    const hid_t memory = H5Screate(H5S_SCALAR);
    const bool real = kind == H5T_FLOAT;
    H5Dwrite(table, real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64, memory, space, H5P_DEFAULT,
             real ? static_cast<const void*>(&number) : &integer);
    H5Sclose(memory);
  }
  H5Tclose(type);
}

void change_number(hid_t file, Source& source) {
  // To write into a table HDF5 makes an index of all its chunks in memory, whatever its size; an edit replaces tables
  // by ones of any size.
  constexpr double kMostNumbers = 1 << 17;
  const hid_t table = H5Dopen2(file, source.pick(kTables), H5P_DEFAULT);
  if (table < 0) return;
  const hid_t space = H5Dget_space(table);
  hsize_t size[3] = {}, at[3] = {}, one[3] = {1, 1, 1};
  H5Sget_simple_extent_dims(space, size, nullptr);
  for (int i = 0; i < 3; ++i) at[i] = size[i] > 0 ? source.take<std::uint16_t>() % size[i] : 0;
  const auto number = source.take<double>();
  const auto integer = source.take<std::int64_t>();
  const double numbers = std::accumulate(size, size + H5Sget_simple_extent_ndims(space), 1.0, std::multiplies<>());
  const bool is_small = numbers <= kMostNumbers;
  if (is_small && H5Sselect_hyperslab(space, H5S_SELECT_SET, at, nullptr, one, nullptr) >= 0) {
    write_number(table, space, number, integer);
  }
  H5Sclose(space);
  H5Dclose(table);
}

void change_row_count(hid_t file, Source& source) {
  const hid_t table = H5Dopen2(file, source.pick(kTables), H5P_DEFAULT);
  if (table < 0) return;
  const hid_t space = H5Dget_space(table);
  hsize_t size[3] = {};
  H5Sget_simple_extent_dims(space, size, nullptr);
  // More rows take HDF5 and the reader long, which finds nothing that fewer do not.
  constexpr hsize_t kMostRows = 1 << 11;
  size[0] = source.take<std::uint32_t>() % kMostRows;
  H5Dset_extent(table, size);
  H5Sclose(space);
  H5Dclose(table);
}

void link_elsewhere(hid_t file, Source& source) {
  const char* path = source.pick(kTables);
  const char* target = source.pick(kTables);
  H5Ldelete(file, path, H5P_DEFAULT);
  if (source.take<std::uint8_t>() % 2 == 0) {
    H5Lcreate_soft(target, file, path, H5P_DEFAULT, H5P_DEFAULT);
  } else {
    H5Lcreate_hard(file, target, file, path, H5P_DEFAULT, H5P_DEFAULT);
  }
}

}  // namespace

void edit_recording(const std::string& path, std::span<const std::uint8_t> edits) {
  constexpr int kMostEdits = 8;
  using Edit = void (*)(hid_t, Source&);
  constexpr std::array<Edit, 6> kEdits = {replace_attribute, remove_table,     replace_table,
                                          change_number,     change_row_count, link_elsewhere};
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  Source source(edits);
  for (int i = 0; i < kMostEdits && !source.empty(); ++i) source.pick(kEdits)(file, source);
  H5Fclose(file);
}

}  // namespace netpocket
