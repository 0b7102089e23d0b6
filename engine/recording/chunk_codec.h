#pragma once
// Encodes chunks for HDF5 faster than HDF5 itself. The filters shuffle, deflate and fletcher32 can decode the result,
// so every HDF5 program can read it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct libdeflate_compressor;

namespace netpocket {

class ChunkCodec {
 public:
  ChunkCodec();

  // Shuffles (byte k of every element goes to plane k), deflates and appends the checksum. The low bytes of floating
  // point numbers are noise. Compressing them would take nine tenths of the time without gain, so planes that look like
  // noise become stored blocks of the deflate stream. The result is never `avoided_size` bytes long. It is valid until
  // the next call.
  std::span<const std::uint8_t> encode(std::span<const std::uint8_t> data, std::size_t element_size,
                                       std::size_t avoided_size = 0);

 private:
  void shuffle(std::span<const std::uint8_t> data, std::size_t element_size);
  void deflate(std::size_t stored_bytes, bool longer);

  struct CompressorDeleter {
    void operator()(libdeflate_compressor* compressor) const;
  };
  std::unique_ptr<libdeflate_compressor, CompressorDeleter> compressor_;
  std::vector<std::uint8_t> planes_;
  std::vector<std::uint8_t> encoded_;
};

// Fletcher's checksum as HDF5 computes it, over big-endian 16-bit words.
std::uint32_t fletcher32(std::span<const std::uint8_t> data);

}  // namespace netpocket
