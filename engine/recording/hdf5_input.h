#pragma once
// Reads tables and attributes from an HDF5 file that is not trusted. Everything is checked before it is read: kind,
// type, dimensions, filters, and whether its size is possible for a file of this length. Errors: Hdf5Error.

#include <cstdint>
#include <string>
#include <vector>

#include "engine/recording/hdf5_support.h"

namespace netpocket {

// Deflate compresses at most 1032 bytes into one.
inline constexpr double kLargestCompression = 1032;

class InputFile {
 public:
  // Opens a finished file, one that is being written, or one whose writer was killed. Throws FileError when it is not
  // readable.
  explicit InputFile(const std::string& path);

  hid_t id() const { return file_.get(); }
  // Whether the writer has closed the file: it was not killed and is not running.
  bool is_closed() const { return is_closed_; }
  bool has(const std::string& path) const;

  // Attributes of the object at `path` ("/" for the file itself).
  bool has_attribute(const std::string& path, const char* name) const;
  std::string read_text_attribute(const std::string& path, const char* name) const;
  double read_number_attribute(const std::string& path, const char* name) const;
  // An integer from 0 to 2^31 - 1.
  std::int32_t read_count_attribute(const std::string& path, const char* name) const;

  // Throws when a file of this length cannot hold so many bytes, even with the best compression.
  void check_plausible(const std::string& what, double bytes) const;
  // Throws when a file of this length cannot hold so many chunks.
  void check_chunk_count(const std::string& what, double chunks) const;

 private:
  Handle file_;
  double bytes_ = 0;
  bool is_closed_ = true;
};

// A dataset of rows. Each row is an array of `shape`.
class InputTable {
 public:
  InputTable() = default;
  // The file's element type must be of this class (H5T_FLOAT, H5T_INTEGER or H5T_STRING).
  InputTable(const InputFile& file, const std::string& path, H5T_class_t type_class,
             const std::vector<hsize_t>& shape = {});

  bool is_open() const { return dataset_.get() >= 0; }
  hsize_t row_count() const { return rows_; }
  std::size_t row_size() const { return row_size_; }  // elements per row

  template <typename T>
  std::vector<T> read(hsize_t first, hsize_t count) const {
    check_range(first, count, sizeof(T));
    std::vector<T> values(count * row_size_);
    read_rows(first, count, native_type<T>(), values.data());
    return values;
  }
  // All rows of a table whose rows announce rows of other tables. After a loss of power its last chunk can have an
  // index entry but no data. Rows in such a chunk are omitted: nothing was guaranteed for them yet.
  std::vector<double> read_announced() const;
  std::vector<std::string> read_texts() const;

 private:
  void check_layout(const InputFile& file, H5T_class_t type_class, const std::vector<hsize_t>& shape);
  void check_filters(const InputFile& file);
  void check_range(hsize_t first, hsize_t count, std::size_t element_bytes) const;
  void read_rows(hsize_t first, hsize_t count, hid_t type, void* out) const;

  std::string path_;
  const InputFile* file_ = nullptr;
  Handle dataset_;
  std::vector<hsize_t> size_;
  hsize_t rows_ = 0, rows_per_chunk_ = 1;
  std::size_t row_size_ = 1;
};

// Reads all rows of a table.
template <typename T>
std::vector<T> read_array(const InputFile& file, const std::string& path, const std::vector<hsize_t>& shape = {}) {
  const InputTable table(file, path, std::is_floating_point_v<T> ? H5T_FLOAT : H5T_INTEGER, shape);
  return table.read<T>(0, table.row_count());
}
std::vector<std::string> read_texts(const InputFile& file, const std::string& path);

}  // namespace netpocket
