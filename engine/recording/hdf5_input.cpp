#include "engine/recording/hdf5_input.h"

#include <sys/stat.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/base/destination.h"

namespace netpocket {

namespace {

constexpr double kSmallFile = 1 << 16;
// Smallest size of a chunk in a file, including its index entry, bytes. HDF5 needs about 200 bytes of memory for each.
constexpr double kSmallestChunk = 16;
constexpr std::size_t kLongestAttribute = 1 << 16;

double size_of_file(const std::string& path) {
  struct stat status = {};
  require_readable(path);
  if (stat(path.c_str(), &status) != 0) throw Hdf5Error(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) throw Hdf5Error("it is not a file");
  return static_cast<double>(status.st_size);
}

// A file that is being written, or whose writer was killed, opens only in SWMR mode (single writer, multiple readers).
Handle open_file(const std::string& path, bool& is_closed) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe file access");
  // Writers use their own lock (output_file.h). HDF5's locks fail on network file systems.
  checked(H5Pset_file_locking(access.get(), false, true), "describe file access");
  hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get());
  is_closed = file >= 0;
  if (!is_closed) {
    // A page that is torn because it is being written becomes whole a moment later. HDF5 doubles its waits from a
    // nanosecond.
    checked(H5Pset_metadata_read_attempts(access.get(), 20), "describe file access");
    file = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get());
  }
  if (file < 0 && path.ends_with(".toml")) throw Hdf5Error("it is a scenario; netpocket run makes a recording of it");
  return Handle(file, H5Fclose, "it is damaged or not an HDF5 file");
}

bool is_allowed_filter(H5Z_filter_t filter) {
  return filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_DEFLATE || filter == H5Z_FILTER_FLETCHER32;
}

// Opens an attribute that must hold one value of a class.
Handle open_attribute(const InputFile& file, const std::string& path, const char* name, H5T_class_t type_class) {
  const std::string what = "attribute " + std::string(name);
  if (!file.has(path)) throw Hdf5Error(path + " is missing");
  Handle attribute(H5Aopen_by_name(file.id(), path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                   what + " is missing");
  const Handle type(H5Aget_type(attribute.get()), H5Tclose, what + " is damaged");
  const Handle space(H5Aget_space(attribute.get()), H5Sclose, what + " is damaged");
  if (H5Sget_simple_extent_npoints(space.get()) != 1 || H5Tget_class(type.get()) != type_class) {
    throw Hdf5Error(what + " has the wrong type");
  }
  return attribute;
}

}  // namespace

InputFile::InputFile(const std::string& path) : bytes_(size_of_file(path)) {
  silence_hdf5();
  file_ = open_file(path, is_closed_);
}

bool InputFile::has(const std::string& path) const {
  if (path == "/") return true;
  // Only hard links are followed: soft or external links could lead outside the file that the user named.
  for (std::size_t end = path.find('/', 1); true; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    H5L_info_t link = {};
    if (H5Lexists(file_.get(), part.c_str(), H5P_DEFAULT) <= 0) return false;
    if (H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) return false;
    if (end == std::string::npos) return true;
  }
}

bool InputFile::has_attribute(const std::string& path, const char* name) const {
  return H5Aexists_by_name(id(), path.c_str(), name, H5P_DEFAULT) > 0;
}

std::string InputFile::read_text_attribute(const std::string& path, const char* name) const {
  const Handle attribute = open_attribute(*this, path, name, H5T_STRING);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose, std::string("read attribute ") + name);
  const std::size_t length = H5Tget_size(type.get());
  if (H5Tis_variable_str(type.get()) != 0 || length > kLongestAttribute) {
    throw Hdf5Error("attribute " + std::string(name) + " has the wrong type");
  }
  std::string text(length, '\0');
  checked(H5Aread(attribute.get(), type.get(), text.data()), std::string("cannot read attribute ") + name);
  return text.substr(0, text.find('\0'));
}

double InputFile::read_number_attribute(const std::string& path, const char* name) const {
  const Handle attribute = open_attribute(*this, path, name, H5T_FLOAT);
  double value = 0;
  checked(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), std::string("cannot read attribute ") + name);
  return value;
}

std::int32_t InputFile::read_count_attribute(const std::string& path, const char* name) const {
  const Handle attribute = open_attribute(*this, path, name, H5T_INTEGER);
  std::int64_t value = 0;
  checked(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value), std::string("cannot read attribute ") + name);
  if (value < 0 || value > std::numeric_limits<std::int32_t>::max()) {
    throw Hdf5Error("attribute " + std::string(name) + " is out of range");
  }
  return static_cast<std::int32_t>(value);
}

void InputFile::check_plausible(const std::string& what, double bytes) const {
  if (bytes > kLargestCompression * bytes_ + kSmallFile) throw Hdf5Error(what + " claims an impossible size");
}

void InputFile::check_chunk_count(const std::string& what, double chunks) const {
  if (chunks * kSmallestChunk > bytes_ + kSmallFile) throw Hdf5Error(what + " claims an impossible number of chunks");
}

InputTable::InputTable(const InputFile& file, const std::string& path, H5T_class_t type_class,
                       const std::vector<hsize_t>& shape)
    : path_(path), file_(&file) {
  if (!file.has(path)) throw Hdf5Error(path + " is missing");
  // H5Dopen fails for groups and named types.
  dataset_ = Handle(H5Dopen2(file.id(), path.c_str(), H5P_DEFAULT), H5Dclose, path + " is damaged");
  check_layout(file, type_class, shape);
  check_filters(file);
}

void InputTable::check_layout(const InputFile& file, H5T_class_t type_class, const std::vector<hsize_t>& shape) {
  const Handle type(H5Dget_type(dataset_.get()), H5Tclose, path_ + " is damaged");
  const Handle space(H5Dget_space(dataset_.get()), H5Sclose, path_ + " is damaged");
  const bool variable = type_class == H5T_STRING && H5Tis_variable_str(type.get()) != 0;
  if (H5Tget_class(type.get()) != type_class || variable) throw Hdf5Error(path_ + " has the wrong type");
  const int rank = static_cast<int>(shape.size()) + 1;
  if (H5Sget_simple_extent_ndims(space.get()) != rank) throw Hdf5Error(path_ + " has the wrong dimensions");
  size_.resize(shape.size() + 1);
  checked(H5Sget_simple_extent_dims(space.get(), size_.data(), nullptr), path_ + " is damaged");
  if (!std::equal(shape.begin(), shape.end(), size_.begin() + 1)) throw Hdf5Error(path_ + " has the wrong dimensions");
  rows_ = size_[0];
  for (const hsize_t n : shape) row_size_ *= n;
  const double element = static_cast<double>(H5Tget_size(type.get()));
  file.check_plausible(path_, static_cast<double>(rows_) * element * static_cast<double>(row_size_));
}

void InputTable::check_filters(const InputFile& file) {
  const Handle properties(H5Dget_create_plist(dataset_.get()), H5Pclose, path_ + " is damaged");
  if (H5Pget_layout(properties.get()) != H5D_CHUNKED) throw Hdf5Error(path_ + " is not stored in chunks");
  std::vector<hsize_t> chunk(size_.size());
  checked(H5Pget_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data()), path_ + " is damaged");
  rows_per_chunk_ = chunk[0];
  double bytes = 8, chunks = 1;
  for (std::size_t i = 0; i < chunk.size(); ++i) {
    bytes *= static_cast<double>(chunk[i]);
    chunks *= std::ceil(static_cast<double>(size_[i]) / static_cast<double>(chunk[i]));
  }
  file.check_plausible(path_, bytes);
  file.check_chunk_count(path_, chunks);
  const int filters = checked(H5Pget_nfilters(properties.get()), path_ + " is damaged");
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const auto filter =
        H5Pget_filter2(properties.get(), static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, nullptr);
    if (!is_allowed_filter(filter)) throw Hdf5Error(path_ + " uses an unknown filter");
  }
}

void InputTable::check_range(hsize_t first, hsize_t count, std::size_t element_bytes) const {
  if (first > rows_ || count > rows_ - first) throw Hdf5Error(path_ + " is shorter than expected");
  file_->check_plausible(path_, static_cast<double>(count) * static_cast<double>(row_size_ * element_bytes) / 8);
}

void InputTable::read_rows(hsize_t first, hsize_t count, hid_t type, void* out) const {
  if (count == 0 || row_size_ == 0) return;
  std::vector<hsize_t> start(size_.size(), 0);
  start[0] = first;
  std::vector<hsize_t> block = size_;
  block[0] = count;
  const std::string attempt = "cannot read " + path_ + ", it is damaged";
  const int rank = static_cast<int>(block.size());
  const Handle memory(H5Screate_simple(rank, block.data(), nullptr), H5Sclose, attempt);
  const Handle space(H5Dget_space(dataset_.get()), H5Sclose, attempt);
  checked(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr), attempt);
  checked(H5Dread(dataset_.get(), type, memory.get(), space.get(), H5P_DEFAULT, out), attempt);
}

std::vector<double> InputTable::read_announced() const {
  try {
    return read<double>(0, rows_);
  } catch (const Hdf5Error&) {
    const hsize_t whole = rows_ == 0 ? 0 : (rows_ - 1) / rows_per_chunk_ * rows_per_chunk_;
    if (file_->is_closed() || whole == 0) throw;
    return read<double>(0, whole);
  }
}

std::vector<std::string> InputTable::read_texts() const {
  const Handle type(H5Dget_type(dataset_.get()), H5Tclose, path_ + " is damaged");
  const std::size_t length = H5Tget_size(type.get());
  std::vector<char> bytes(length * rows_);
  read_rows(0, rows_, type.get(), bytes.data());
  std::vector<std::string> texts(rows_);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const char* begin = bytes.data() + i * length;
    texts[i].assign(begin, strnlen(begin, length));
  }
  return texts;
}

std::vector<std::string> read_texts(const InputFile& file, const std::string& path) {
  return InputTable(file, path, H5T_STRING).read_texts();
}

}  // namespace netpocket
