#pragma once
// Random numbers with the same bits on every processor. The n-th number depends on the seed and n only, so the state is
// one count.
//
// Integers: SplitMix64, a hash of seed + n g (Steele, Lea & Flood 2014, doi:10.1145/2660193.2660195).
// Normal numbers: Karney's algorithm N (2016, doi:10.1145/2710016), which compares uniform numbers and calls no
// elementary function. It is exact but for the 53 bits of its uniform numbers.

#include <cstdint>

#include "engine/control/visited_numbers.h"

namespace netpocket {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : seed_(seed) {}

  std::uint64_t next();  // all 64 bits random
  double uniform();      // from [0, 1), a multiple of 2^-53
  double normal();       // mean 0, standard deviation 1

  void visit_state(const NumberVisitor& visit) { visit_count(visit, count_); }

 private:
  bool happens(double exponent);
  bool happens_each_time(int times, double exponent);

  std::uint64_t seed_;
  std::uint64_t count_ = 0;  // of integers drawn so far
};

}  // namespace netpocket
