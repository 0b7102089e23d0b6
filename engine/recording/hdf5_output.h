#pragma once
// Writes tables and attributes to an HDF5 file.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/recording/chunk_codec.h"
#include "engine/recording/hdf5_support.h"

namespace netpocket {

void write_attribute(hid_t object, const char* name, const std::string& text);
void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, std::int64_t value);

Handle create_group(hid_t parent, const char* name);

// Description of a table: every row is an array of `shape` (empty: a scalar) of the table's type.
struct TableLayout {
  const char* name;
  const char* unit;  // SI, "1" for pure numbers, "" for text and indices
  const char* help;
  std::vector<hsize_t> shape = {};
  hsize_t rows_per_chunk = 1;
};

// A dataset that grows by rows. append() buffers rows and store() writes them to the file. The codec encodes chunks,
// which are written directly, to avoid HDF5's slower filter pipeline and chunk cache.
class OutputTable {
 public:
  OutputTable(hid_t parent, hid_t type, const TableLayout& layout, ChunkCodec& codec);

  template <typename T>
  void append(std::span<const T> values) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    buffer_.insert(buffer_.end(), bytes, bytes + values.size_bytes());
  }
  // Text shorter than the type is padded; longer text is truncated.
  void append_text(const std::string& text);

  // Writes the buffered rows. The last chunk may be partly filled; it is written again when it has grown.
  void store();
  hid_t dataset() const { return dataset_.get(); }
  hsize_t row_count() const { return first_buffered_row_ + buffer_.size() / row_bytes_; }

 private:
  void write_chunk(hsize_t first_row, std::span<const std::uint8_t> rows);

  std::string name_;
  std::size_t rank_;
  std::size_t element_bytes_;
  std::size_t row_bytes_;
  hsize_t rows_per_chunk_;
  std::vector<hsize_t> extent_;
  Handle dataset_;
  ChunkCodec* codec_;
  hsize_t first_buffered_row_ = 0;  // a multiple of rows_per_chunk_
  hsize_t stored_rows_ = 0;
  hsize_t last_chunk_row_ = 0;       // first row of the chunk written last
  std::size_t last_chunk_size_ = 0;  // bytes, in the file
  std::vector<std::uint8_t> buffer_;
};

// Writes a whole array as one chunk.
template <typename T>
void write_array(hid_t parent, TableLayout layout, const std::vector<T>& values, ChunkCodec& codec) {
  std::size_t row = 1;
  for (const hsize_t n : layout.shape) row *= n;
  layout.rows_per_chunk = std::max<hsize_t>(1, values.size() / row);
  OutputTable table(parent, native_type<T>(), layout, codec);
  table.append(std::span<const T>(values));
  table.store();
}
void write_texts(hid_t parent, TableLayout layout, const std::vector<std::string>& texts, ChunkCodec& codec);

}  // namespace netpocket
