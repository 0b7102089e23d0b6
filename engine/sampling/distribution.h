#pragma once
// Distributions of uncertain inputs. Each is given by its quantile function, the inverse of its cumulative
// distribution, so that any design on the unit cube (design.h) can draw from it. Values have the unit of the input.
// Pure functions: any thread may call them.

#include <string>
#include <variant>
#include <vector>

namespace netpocket {

struct Normal {
  double mean = 0;
  double deviation = 1;  // standard deviation, > 0
};

// A normal distribution given that the value lies within [min, max]. `mean` and `deviation` are those before it is cut.
struct TruncatedNormal {
  double mean = 0;
  double deviation = 1;  // > 0
  double min = -1;
  double max = 1;  // > min
};

struct Uniform {
  double min = 0;
  double max = 1;  // > min
};

// The logarithm is normal.
struct LogNormal {
  double median = 1;         // > 0
  double log_deviation = 1;  // standard deviation of the natural logarithm, > 0
};

struct Triangular {
  double min = 0;
  double mode = 0.5;  // most likely value, from min to max
  double max = 1;     // > min
};

// A value of the list, with a probability in proportion to its weight.
struct Discrete {
  std::vector<double> values;
  std::vector<double> weights;  // one per value, each >= 0, their sum > 0; empty: all alike
};

// Measured values, each equally likely. No distribution is fitted.
struct Samples {
  std::vector<double> values;
};

using Distribution = std::variant<Normal, TruncatedNormal, Uniform, LogNormal, Triangular, Discrete, Samples>;

// What is wrong with the numbers of a distribution, as the rest of a sentence that begins with the input's name ("needs
// a deviation > 0, not -1"). Empty if nothing is. The other functions need a distribution without fault.
std::string find_fault(const Distribution& distribution);

// The value below which the share `fraction` of all draws lies. Fractions beyond 2^-53 and 1 - 2^-53 are moved there,
// so that the result is always finite. Values of a list come in increasing order: a larger fraction never gives a
// smaller value.
double quantile(const Distribution& distribution, double fraction);

// Share of all draws that are at most x.
double cumulative(const Distribution& distribution, double x);

}  // namespace netpocket
