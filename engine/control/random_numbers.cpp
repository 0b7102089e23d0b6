#include "engine/control/random_numbers.h"

namespace netpocket {

std::uint64_t RandomNumbers::next() {
  std::uint64_t z = seed_ + ++count_ * 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double RandomNumbers::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

// True with the probability exp(-exponent), 0 <= exponent <= 1. The falling run exponent > u1 > ... > un has exactly n
// members with the probability exponent^n/n! - exponent^(n+1)/(n+1)!; the sum over even n is the exponential (von
// Neumann 1951).
bool RandomNumbers::happens(double exponent) {
  bool even = true;
  for (double last = exponent;; even = !even) {
    const double u = uniform();
    if (!(u < last)) return even;
    last = u;
  }
}

bool RandomNumbers::happens_each_time(int times, double exponent) {
  for (int i = 0; i < times; ++i) {
    if (!happens(exponent)) return false;
  }
  return true;
}

// The number is k + x with a whole k and x in [0, 1). exp(-(k + x)^2/2) is the product of the probabilities of the
// three draws: exp(-k/2), exp(-k (k - 1)/2), exp(-x (2 k + x)/2).
double RandomNumbers::normal() {
  for (;;) {
    int k = 0;
    while (happens(0.5)) ++k;
    if (!happens_each_time(k * (k - 1), 0.5)) continue;
    const double x = uniform();
    if (!happens_each_time(k + 1, x * (2 * k + x) / (2 * k + 2))) continue;
    return (next() >> 63) == 0 ? k + x : -(k + x);
  }
}

}  // namespace netpocket
