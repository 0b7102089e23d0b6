#pragma once
// Random numbers that depend only on their address: seed, point and number. Points of a design have independent
// numbers, and adding points changes none of the others. The generator is Philox4x32-10: Salmon, Moraes, Dror & Shaw
// (2011), Parallel random numbers: as easy as 1, 2, 3, Proc. SC11, doi:10.1145/2063384.2063405. It uses integers only,
// so its bits are the same on every processor. Pure functions: any thread may call them.

#include <array>
#include <cstdint>
#include <limits>

namespace netpocket {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key);

// What numbers are for. Different purposes of the same seed have independent numbers.
enum class RandomPurpose : std::uint32_t { coordinate, permutation, scrambling, lower_digits, shift, sequence };

// The four words at an address.
PhiloxCounter random_words(std::uint64_t seed, std::uint64_t point, std::uint32_t number, RandomPurpose purpose);

// Evenly distributed in (0, 1); neither end is possible. It is (k + 1/2) / 2^52 with a whole number k.
double random_fraction(std::uint64_t seed, std::uint64_t point, std::uint32_t number,
                       RandomPurpose purpose = RandomPurpose::coordinate);

// The numbers of one point in their order, for methods that need a sequence. Satisfies UniformRandomBitGenerator. It is
// a value: a copy repeats the numbers that follow.
class RandomSequence {
 public:
  using result_type = std::uint32_t;

  explicit RandomSequence(std::uint64_t seed, std::uint64_t point = 0) : seed_(seed), point_(point) {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
  result_type operator()();
  double fraction();                         // in (0, 1)
  double normal();                           // mean 0, standard deviation 1
  std::uint32_t below(std::uint32_t count);  // 0 to count - 1, all equally likely; count >= 1

 private:
  std::uint64_t seed_, point_;
  std::uint32_t next_ = 0;
};

}  // namespace netpocket
