#include "engine/recording/hdf5_output.h"

#include <algorithm>
#include <limits>

namespace netpocket {

namespace {

void write_scalar_attribute(hid_t object, const char* name, hid_t type, const void* value) {
  const std::string attempt = std::string("write attribute ") + name;
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, attempt);
  const Handle attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, attempt);
  checked(H5Awrite(attribute.get(), type, value), attempt);
}

// Floating point rows that a killed program announced but did not write read as NaN.
void set_fill_value(hid_t properties, hid_t type) {
  if (H5Tget_class(type) != H5T_FLOAT) return;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  checked(H5Pset_fill_value(properties, H5T_NATIVE_DOUBLE, &nan), "set a fill value");
}

Handle table_properties(hid_t type, const std::vector<hsize_t>& chunk) {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "describe a table");
  checked(H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data()), "describe a table");
  checked(H5Pset_shuffle(properties.get()), "use the shuffle filter");
  checked(H5Pset_deflate(properties.get(), 1), "use the deflate filter");
  checked(H5Pset_fletcher32(properties.get()), "use the checksum filter");
  set_fill_value(properties.get(), type);
  return properties;
}

Handle create_dataset(hid_t parent, hid_t type, const TableLayout& layout, const std::string& attempt) {
  std::vector<hsize_t> size = {0};
  size.insert(size.end(), layout.shape.begin(), layout.shape.end());
  std::vector<hsize_t> limit = size;
  limit[0] = H5S_UNLIMITED;
  std::vector<hsize_t> chunk = size;
  chunk[0] = layout.rows_per_chunk;
  const Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), limit.data()), H5Sclose, attempt);
  const Handle properties = table_properties(type, chunk);
  return Handle(H5Dcreate2(parent, layout.name, type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                H5Dclose, attempt);
}

}  // namespace

void write_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type = text_type(std::max<std::size_t>(1, text.size()));
  write_scalar_attribute(object, name, type.get(), text.c_str());
}

void write_attribute(hid_t object, const char* name, double value) {
  write_scalar_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t object, const char* name, std::int64_t value) {
  write_scalar_attribute(object, name, H5T_NATIVE_INT64, &value);
}

Handle create_group(hid_t parent, const char* name) {
  return Handle(H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                std::string("create group ") + name);
}

OutputTable::OutputTable(hid_t parent, hid_t type, const TableLayout& layout, ChunkCodec& codec)
    : name_(layout.name),
      rank_(layout.shape.size() + 1),
      element_bytes_(H5Tget_size(type)),
      row_bytes_(element_bytes_),
      rows_per_chunk_(layout.rows_per_chunk),
      extent_({0}),
      dataset_(create_dataset(parent, type, layout, "create table " + name_)),
      codec_(&codec) {
  for (const hsize_t n : layout.shape) row_bytes_ *= n;
  extent_.insert(extent_.end(), layout.shape.begin(), layout.shape.end());
  write_attribute(dataset_.get(), "unit", std::string(layout.unit));
  write_attribute(dataset_.get(), "help", std::string(layout.help));
}

void OutputTable::append_text(const std::string& text) {
  const std::size_t end = buffer_.size() + row_bytes_;
  buffer_.insert(buffer_.end(), text.begin(),
                 text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), row_bytes_)));
  buffer_.resize(end, 0);
}

void OutputTable::store() {
  if (row_count() == stored_rows_) return;
  extent_[0] = row_count();
  checked(H5Dset_extent(dataset_.get(), extent_.data()), "extend table " + name_);
  const std::size_t chunk_bytes = row_bytes_ * rows_per_chunk_;
  const std::size_t full = buffer_.size() / chunk_bytes * chunk_bytes;
  const std::span<const std::uint8_t> all(buffer_);
  for (std::size_t at = 0; at < full; at += chunk_bytes) {
    write_chunk(first_buffered_row_ + at / row_bytes_, all.subspan(at, chunk_bytes));
  }
  if (full < buffer_.size()) {
    std::vector<std::uint8_t> partial(buffer_.begin() + static_cast<std::ptrdiff_t>(full), buffer_.end());
    // All ones are NaN. If a loss of power leaves the table's new length with its old chunk, these rows do not exist.
    partial.resize(chunk_bytes, 0xff);
    write_chunk(first_buffered_row_ + full / row_bytes_, partial);
  }
  stored_rows_ = row_count();
  first_buffered_row_ += full / row_bytes_;
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(full));
}

void OutputTable::write_chunk(hsize_t first_row, std::span<const std::uint8_t> rows) {
  // If a chunk that has grown were encoded to the same size, it would be written in its old place, where a loss of
  // power can tear it. A chunk of another size gets a new place.
  const std::size_t avoided_size = first_row == last_chunk_row_ ? last_chunk_size_ : 0;
  const auto encoded = codec_->encode(rows, element_bytes_, avoided_size);
  last_chunk_row_ = first_row;
  last_chunk_size_ = encoded.size();
  std::vector<hsize_t> offset(rank_, 0);
  offset[0] = first_row;
  checked(H5Dwrite_chunk(dataset_.get(), H5P_DEFAULT, 0, offset.data(), encoded.size(), encoded.data()),
          "write table " + name_);
}

void write_texts(hid_t parent, TableLayout layout, const std::vector<std::string>& texts, ChunkCodec& codec) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  layout.rows_per_chunk = std::max<hsize_t>(1, texts.size());
  const Handle type = text_type(longest);
  OutputTable table(parent, type.get(), layout, codec);
  for (const std::string& text : texts) table.append_text(text);
  table.store();
}

}  // namespace netpocket
