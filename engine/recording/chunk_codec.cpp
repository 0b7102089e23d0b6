#include "engine/recording/chunk_codec.h"

#include <libdeflate.h>

#include <algorithm>
#include <bitset>
#include <iterator>
#include <new>

namespace netpocket {

namespace {

constexpr int kCompressionLevel = 1;
constexpr std::size_t kStoredBlockLimit = 65535;  // RFC 1951, 3.2.4
constexpr std::size_t kStoredBlockHeader = 5;
constexpr std::uint8_t kEmptyStoredBlock[kStoredBlockHeader] = {0, 0, 0, 0xff, 0xff};  // not the last block
constexpr std::size_t kChecksumBytes = 4;

// 256 uniformly random bytes have 162 distinct values on average; with 128 equally likely values there are 111. A plane
// with more than 100 would shrink by less than an eighth.
bool looks_like_noise(std::span<const std::uint8_t> plane) {
  constexpr std::size_t kSample = 256;
  constexpr std::size_t kDistinctValuesOfNoise = 100;
  if (plane.size() < kSample) return false;
  std::bitset<256> seen;
  const std::size_t stride = plane.size() / kSample;
  for (std::size_t i = 0; i < kSample; ++i) seen.set(plane[i * stride]);
  return seen.count() > kDistinctValuesOfNoise;
}

std::size_t leading_noise(std::span<const std::uint8_t> planes, std::size_t element_size) {
  const std::size_t plane_size = planes.size() / element_size;
  std::size_t bytes = 0;
  while (bytes < planes.size() && looks_like_noise(planes.subspan(bytes, plane_size))) bytes += plane_size;
  return bytes;
}

void append_little_endian(std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void append_stored_blocks(std::vector<std::uint8_t>& out, std::span<const std::uint8_t> data) {
  while (!data.empty()) {
    const auto block = data.first(std::min(data.size(), kStoredBlockLimit));
    const auto length = static_cast<std::uint32_t>(block.size());
    out.push_back(0);  // not the last block, type "stored"
    append_little_endian(out, length, 2);
    append_little_endian(out, ~length & 0xffffu, 2);
    out.insert(out.end(), block.begin(), block.end());
    data = data.subspan(block.size());
  }
}

}  // namespace

void ChunkCodec::CompressorDeleter::operator()(libdeflate_compressor* compressor) const {
  libdeflate_free_compressor(compressor);
}

ChunkCodec::ChunkCodec() : compressor_(libdeflate_alloc_compressor(kCompressionLevel)) {
  if (!compressor_) throw std::bad_alloc();
}

std::span<const std::uint8_t> ChunkCodec::encode(std::span<const std::uint8_t> data, std::size_t element_size,
                                                 std::size_t avoided_size) {
  shuffle(data, element_size);
  const std::size_t noise = leading_noise(planes_, element_size);
  deflate(noise, false);
  if (encoded_.size() + kChecksumBytes == avoided_size) deflate(noise, true);
  append_little_endian(encoded_, fletcher32(encoded_), kChecksumBytes);
  return encoded_;
}

void ChunkCodec::shuffle(std::span<const std::uint8_t> data, std::size_t element_size) {
  planes_.resize(data.size());
  const std::size_t count = data.size() / element_size;
  for (std::size_t k = 0; k < element_size; ++k) {
    std::uint8_t* plane = planes_.data() + k * count;
    const std::uint8_t* byte = data.data() + k;
    for (std::size_t i = 0; i < count; ++i) plane[i] = byte[i * element_size];
  }
}

// `longer`: adds an empty block.
void ChunkCodec::deflate(std::size_t stored_bytes, bool longer) {
  const std::span<const std::uint8_t> all(planes_);
  const auto rest = all.subspan(stored_bytes);
  encoded_.assign({0x78, 0x01});  // zlib header (RFC 1950): deflate, 32 KiB window, fastest
  if (longer) encoded_.insert(encoded_.end(), std::begin(kEmptyStoredBlock), std::end(kEmptyStoredBlock));
  append_stored_blocks(encoded_, all.first(stored_bytes));

  const std::size_t start = encoded_.size();
  const std::size_t bound = libdeflate_deflate_compress_bound(compressor_.get(), rest.size()) + kStoredBlockHeader;
  encoded_.resize(start + bound);
  const std::size_t packed =
      libdeflate_deflate_compress(compressor_.get(), rest.data(), rest.size(), encoded_.data() + start, bound);
  encoded_.resize(start + packed);

  const std::uint32_t adler = libdeflate_adler32(1, all.data(), all.size());
  for (int shift = 24; shift >= 0; shift -= 8) encoded_.push_back(static_cast<std::uint8_t>(adler >> shift));
}

std::uint32_t fletcher32(std::span<const std::uint8_t> data) {
  constexpr std::size_t kWordsWithoutOverflow = 360;
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffffu) + (sum >> 16); };
  std::uint32_t sum1 = 0;
  std::uint32_t sum2 = 0;
  std::size_t words = data.size() / 2;
  const std::uint8_t* byte = data.data();
  while (words > 0) {
    const std::size_t block = std::min(words, kWordsWithoutOverflow);
    words -= block;
    for (std::size_t i = 0; i < block; ++i, byte += 2) {
      sum1 += static_cast<std::uint32_t>(byte[0] << 8 | byte[1]);
      sum2 += sum1;
    }
    sum1 = fold(sum1);
    sum2 = fold(sum2);
  }
  if (data.size() % 2 != 0) {
    sum1 = fold(sum1 + (static_cast<std::uint32_t>(*byte) << 8));
    sum2 = fold(sum2 + sum1);
  }
  return fold(sum2) << 16 | fold(sum1);
}

}  // namespace netpocket
