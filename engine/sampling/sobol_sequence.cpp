#include "engine/sampling/sobol_sequence.h"

#include <array>
#include <bit>
#include <boost/random/sobol.hpp>
#include <vector>

#include "engine/sampling/design.h"
#include "engine/sampling/random.h"

namespace netpocket {
namespace {

constexpr int kBits = 32;

// By bit of the Gray code of a point's index, then by axis.
using Directions = std::array<std::array<std::uint32_t, kMostDimensions>, kBits>;

Directions joe_kuo_directions() {
  using Engine = boost::random::sobol_engine<std::uint32_t, kBits>;
  Directions directions;
  Engine engine(kMostDimensions);
  for (int bit = 0; bit < kBits; ++bit) {
    // The engine leaves out the origin: after seed(n) it gives point n + 1.
    std::array<std::uint32_t, kMostDimensions> before{}, after{};
    const std::uint32_t place = std::uint32_t{1} << bit;  // the Gray codes of place - 1 and place differ in this bit
    if (place > 1) {
      engine.seed(place - 2);
      engine.generate(before.begin(), before.end());
    }
    engine.seed(place - 1);
    engine.generate(after.begin(), after.end());
    for (std::size_t axis = 0; axis < before.size(); ++axis) directions[bit][axis] = before[axis] ^ after[axis];
  }
  return directions;
}

const Directions& directions() {
  static const Directions kDirections = joe_kuo_directions();
  return kDirections;
}

std::uint32_t sobol_bits(std::uint64_t index, int axis) {
  const Directions& of_bits = directions();
  std::uint32_t bits = 0;
  std::uint64_t gray = index ^ index >> 1;
  for (std::size_t bit = 0; bit < kBits; ++bit, gray >>= 1) {
    if ((gray & 1) != 0) bits ^= of_bits[bit][static_cast<std::size_t>(axis)];
  }
  return bits;
}

std::uint32_t reversed(std::uint32_t x) {
  std::uint32_t result = 0;
  for (int bit = 0; bit < kBits; ++bit, x >>= 1) result = result << 1 | (x & 1);
  return result;
}

// Each bit of the result depends only on the bits of x up to it.
std::uint32_t laine_karras_hash(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

double as_fraction(std::uint32_t bits) { return static_cast<double>(bits) * 0x1p-32; }

}  // namespace

double sobol(std::uint64_t index, int axis) { return as_fraction(sobol_bits(index, axis)); }

// The Gray codes of an index and of the one before it differ in the lowest bit that is set in the index.
void SobolWalk::next() {
  const auto& direction = directions()[static_cast<std::size_t>(std::countr_zero(++index_))];
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions_); ++axis) bits_[axis] ^= direction[axis];
}

double SobolWalk::operator[](int axis) const { return as_fraction(bits_[static_cast<std::size_t>(axis)]); }

double scrambled_sobol(std::uint64_t index, int axis, std::uint64_t seed) {
  const PhiloxCounter words = random_words(seed, 0, static_cast<std::uint32_t>(axis), RandomPurpose::scrambling);
  const std::uint32_t scrambled = reversed(laine_karras_hash(reversed(sobol_bits(index, axis)), words[0]));
  const double lower_digits =
      random_fraction(seed, index, static_cast<std::uint32_t>(axis), RandomPurpose::lower_digits);
  return as_fraction(scrambled) + 0x1p-32 * lower_digits;
}

}  // namespace netpocket
