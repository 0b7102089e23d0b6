#pragma once
// Minimisation without derivatives of functions that may be noisy, with bounds: CMA-ES with restarts. Hansen (2016),
// The CMA evolution strategy: a tutorial, arXiv:1604.00772; restarts with growing populations (IPOP): Auger & Hansen
// (2005), doi:10.1109/CEC.2005.1554902. Debian 12 has no library for it under a permissive licence.
//
// Variables are scaled to the unit cube. The search distribution knows no bounds: points beyond one are mirrored at it,
// which makes the function periodic and leaves its minima where they are, at bounds too. Thread contract: any thread
// may call it. The same seed gives the same points.

#include <cstdint>
#include <limits>

#include "engine/statistics/batch_function.h"

namespace netpocket {

struct MinimisationOptions {
  Eigen::VectorXd lower, upper;                              // bounds, finite, lower < upper
  Eigen::VectorXd start = {};                                // empty: the middle
  double step = 0.3;                                         // first standard deviation, as a fraction of the range
  int population = 0;                                        // of the first run; 0: 4 + floor(3 ln n)
  int most_evaluations = 10000;                              // no new generation begins beyond it
  int most_restarts = 9;                                     // each with twice the population, from a random point
  double target = -std::numeric_limits<double>::infinity();  // a value at which the search ends
  double least_step = 1e-10;                                 // as a fraction of the range, at which a run has converged
  std::uint64_t seed = 1;
};

struct Minimum {
  Eigen::VectorXd point;  // best that was evaluated
  double value = std::numeric_limits<double>::infinity();
  int evaluations = 0;
  int restarts = 0;
  bool has_reached_target = false;
};

// Population of the first run: 4 + floor(3 ln n), table 1 of the tutorial.
int default_population(int dimensions);

// Values that are not finite count as worse than all others.
Minimum minimise(const BatchFunction& function, const MinimisationOptions& options);

}  // namespace netpocket
