// HDF5's own filters must understand what the codec writes.
#include "engine/recording/chunk_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/recording/hdf5_output.h"
#include "tests/engine/recording/synthetic_run.h"

namespace netpocket {
namespace {

// Writes with the codec, reads with HDF5's filter pipeline.
template <typename T>
std::vector<T> through_hdf5(const std::vector<T>& values) {
  const TemporaryFolder folder;
  const Handle file(H5Fcreate(folder.file("codec.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                    "create");
  ChunkCodec codec;
  write_array(file.get(), {"values", "1", "test"}, values, codec);
  const Handle dataset(H5Dopen2(file.get(), "values", H5P_DEFAULT), H5Dclose, "open");
  std::vector<T> found(values.size());
  checked(H5Dread(dataset.get(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, found.data()), "read");
  return found;
}

template <typename T>
std::vector<T> noisy_wave(std::size_t count) {
  std::minstd_rand random(1);
  std::vector<T> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] =
        static_cast<T>(100 * std::sin(0.01 * static_cast<double>(i)) + static_cast<double>(random() % 1000) * 1e-5);
  }
  return values;
}

TEST(ChunkCodec, IsReadByHdf5) {
  // 300000: stored blocks hold 65535 bytes; odd counts: the checksum's last byte stands alone.
  for (const std::size_t count : {1u, 2u, 255u, 257u, 4097u, 300000u}) {
    EXPECT_EQ(through_hdf5(noisy_wave<float>(count)), noisy_wave<float>(count));
    EXPECT_EQ(through_hdf5(noisy_wave<double>(count)), noisy_wave<double>(count));
    EXPECT_EQ(through_hdf5(noisy_wave<std::int32_t>(count)), noisy_wave<std::int32_t>(count));
    EXPECT_EQ(through_hdf5(noisy_wave<std::int64_t>(count)), noisy_wave<std::int64_t>(count));
    EXPECT_EQ(through_hdf5(std::vector<std::uint8_t>(count, 3)), std::vector<std::uint8_t>(count, 3));
    EXPECT_EQ(through_hdf5(std::vector<float>(count, 0.0f)), std::vector<float>(count, 0.0f));
  }
}

TEST(ChunkCodec, IsReadByHdf5WhenLonger) {
  const auto values = noisy_wave<float>(1000);
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(values.data()), 4000);
  ChunkCodec codec;
  const std::size_t size = codec.encode(bytes, 4).size();
  const TemporaryFolder folder;
  const Handle file(H5Fcreate(folder.file("codec.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                    "create");
  write_array(file.get(), {"values", "1", "test"}, std::vector<float>(1000), codec);
  const Handle dataset(H5Dopen2(file.get(), "values", H5P_DEFAULT), H5Dclose, "open");
  const auto longer = codec.encode(bytes, 4, size);
  EXPECT_GT(longer.size(), size);
  const hsize_t start = 0;
  checked(H5Dwrite_chunk(dataset.get(), H5P_DEFAULT, 0, &start, longer.size(), longer.data()), "write");
  std::vector<float> found(1000);
  checked(H5Dread(dataset.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, found.data()), "read");
  EXPECT_EQ(found, values);
}

TEST(ChunkCodec, ShrinksWhatCanShrink) {
  ChunkCodec codec;
  const std::vector<std::uint8_t> zeros(40000, 0);
  EXPECT_LT(codec.encode(zeros, 4).size(), zeros.size() / 100);
  // The exponents of a smooth signal: a fifth of a float or more.
  const auto wave = noisy_wave<float>(10000);
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(wave.data()), 40000);
  EXPECT_LT(codec.encode(bytes, 4).size(), 33000u);
}

// Published test vectors are for little-endian words; this is "abcdefgh" with HDF5's big-endian words, by hand:
// words 6162 6364 6566 6768, sum 1 = 19194 -> 9195, sum 2 = 6162 + c4c6 + 12a2c + 19194 = 3e1e8 -> e1eb.
TEST(ChunkCodec, ChecksumIsFletchers) {
  const std::string text = "abcdefgh";
  EXPECT_EQ(fletcher32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), 0xe1eb9195u);
}

}  // namespace
}  // namespace netpocket
