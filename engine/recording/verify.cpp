#include "engine/recording/verify.h"

#include <fmt/format.h>

#include <span>

#include "engine/recording/chunk_codec.h"
#include "engine/recording/hdf5_input.h"
#include "engine/recording/recording.h"

namespace netpocket {

namespace {

constexpr std::size_t kListedProblems = 20;
constexpr std::size_t kChecksumBytes = 4;

class Verifier {
 public:
  explicit Verifier(const std::string& path) : file_(path), recording_(path) {
    silence_hdf5();
    read_values();
    H5Ovisit2(file_.id(), H5_INDEX_NAME, H5_ITER_INC, visit, this, H5O_INFO_BASIC);
  }

  Verification result() && { return std::move(result_); }

 private:
  static herr_t visit(hid_t file, const char* name, const H5O_info_t* info, void* self) {
    if (info->type == H5O_TYPE_DATASET) static_cast<Verifier*>(self)->check_table(file, name);
    return 0;
  }

  void add(std::string problem) {
    if (result_.problems.size() < kListedProblems) result_.problems.push_back(std::move(problem));
  }

  void read_values() {
    result_.frames = recording_.frame_count();
    result_.checkpoints = recording_.checkpoint_times().size();
    for (std::size_t i = 0; i < result_.frames; ++i) {
      attempt([&] {
        const Snapshot frame = recording_.frame(i);
        const bool finite = frame.positions.allFinite() && frame.velocities.allFinite() &&
                            frame.gradients.allFinite() && frame.tension.allFinite() && frame.strain.allFinite();
        if (!finite) add(fmt::format("frame {} holds numbers that are not finite", i));
      });
    }
    for (std::size_t i = 0; i < result_.checkpoints; ++i) attempt([&] { recording_.checkpoint(i); });
  }

  template <typename Action>
  void attempt(const Action& action) {
    try {
      action();
    } catch (const RecordingError& error) {
      add(error.what());
    }
  }

  // Chunks hold whole rows (FORMAT.md). They are read as stored and their checksums are computed here, including those
  // of rows that no frame uses.
  void check_table(hid_t file, const std::string& name) {
    try {
      const Handle table(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open " + name);
      const Handle properties(H5Dget_create_plist(table.get()), H5Pclose, "describe " + name);
      const Handle space(H5Dget_space(table.get()), H5Sclose, "describe " + name);
      std::vector<hsize_t> size(H5S_MAX_RANK), chunk(H5S_MAX_RANK);
      checked(H5Sget_simple_extent_dims(space.get(), size.data(), nullptr), "describe " + name);
      checked(H5Pget_chunk(properties.get(), H5S_MAX_RANK, chunk.data()), "find the chunks of " + name);
      file_.check_chunk_count(name, static_cast<double>(size[0]) / static_cast<double>(chunk[0]));
      for (hsize_t row = 0; row < size[0]; row += chunk[0]) check_chunk(table.get(), name, row);
    } catch (const Hdf5Error& error) {
      add(fmt::format("cannot {}", error.what()));
    }
  }

  void check_chunk(hid_t table, const std::string& name, hsize_t row) {
    std::vector<hsize_t> offset(H5S_MAX_RANK);
    offset[0] = row;
    hsize_t size = 0;
    // Rows that a killed program announced may have no chunk.
    if (H5Dget_chunk_storage_size(table, offset.data(), &size) < 0 || size == 0) return;
    file_.check_plausible(name, static_cast<double>(size));
    std::vector<std::uint8_t> bytes(size);
    std::uint32_t filters = 0;
    checked(H5Dread_chunk(table, H5P_DEFAULT, offset.data(), &filters, bytes.data()), "read a chunk of " + name);
    ++result_.chunks;
    result_.bytes += size;
    if (!has_valid_checksum(bytes)) add(fmt::format("{}: the chunk at row {} is damaged", name, row));
  }

  // The checksum is the last four bytes of a chunk, little-endian.
  static bool has_valid_checksum(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < kChecksumBytes) return false;
    const auto stored = bytes.last(kChecksumBytes);
    std::uint32_t checksum = 0;
    for (std::size_t i = 0; i < kChecksumBytes; ++i) checksum |= std::uint32_t{stored[i]} << (8 * i);
    return checksum == fletcher32(bytes.first(bytes.size() - kChecksumBytes));
  }

  InputFile file_;
  Recording recording_;
  Verification result_;
};

}  // namespace

Verification verify_recording(const std::string& path) {
  try {
    return Verifier(path).result();
  } catch (const Hdf5Error& error) {
    throw RecordingError(fmt::format("cannot read \"{}\": {}", path, error.what()));
  }
}

}  // namespace netpocket
