#pragma once
// Helpers for the HDF5 C API that reading and writing share: owned identifiers and checked calls.

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace netpocket {

// A failed HDF5 call. The message says what was attempted. Never leaves this library: recorder.cpp and recording.cpp
// convert it to a RecordingError that names the file.
class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Stops HDF5 from printing its error stack, for the calling thread.
void silence_hdf5();

// The operating system's reason in HDF5's error stack ("No space left on device"), or "".
std::string hdf5_system_reason();

// Throws Hdf5Error when `result` is negative; otherwise returns it.
template <typename T>
T checked(T result, const std::string& attempt) {
  if (result >= 0) return result;
  const std::string reason = hdf5_system_reason();
  throw Hdf5Error(reason.empty() ? attempt : attempt + " (" + reason + ")");
}

// Owns an HDF5 identifier.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close, const std::string& attempt) : id_(checked(id, attempt)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { reset(); }

  hid_t get() const { return id_; }
  // Closes the identifier now; false when HDF5 could not.
  bool reset() { return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }
  // Leaves the identifier open until the program ends.
  void abandon() { id_ = H5I_INVALID_HID; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

// HDF5's native type of a C++ number type.
template <typename T>
hid_t native_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

// UTF-8 text of a fixed number of bytes, padded with zeros. (HDF5's variable-length text has no checksum.)
Handle text_type(std::size_t bytes);

}  // namespace netpocket
