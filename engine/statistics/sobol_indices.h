#pragma once
// Sobol indices: which share of an output's variance comes from which input. Design: Saltelli, Annoni, Azzini,
// Campolongo, Ratto & Tarantola (2010), Comput. Phys. Commun. 181(2), doi:10.1016/j.cpc.2009.09.018. Pure functions:
// any thread may call them.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/statistics/interval.h"

namespace netpocket {

// Points of the unit cube, one column each, in `blocks` blocks of dimensions + 2: a point a, a point b, and for each
// input a with this input from b. The blocks are those of a scrambled Sobol sequence of 2 x dimensions coordinates (at
// most kMostDimensions of design.h), best taken in powers of 2. More blocks keep the old ones.
Eigen::MatrixXd variance_points(int dimensions, int blocks, std::uint64_t seed);

struct Estimate {
  double value = 0;
  Interval interval;
};

struct SobolIndices {
  Estimate first;  // share of the variance due to the input alone: eq. (b) of table 2 of Saltelli et al. (2010)
  Estimate total;  // the same with all that it does together with others: Jansen (1999), Comput. Phys. Commun.
                   // 117(1), doi:10.1016/S0010-4655(98)00154-4
};

// By input. `outputs`: one per point, in their order; blocks with an output that is not finite are left out. The
// intervals come from `resamples` bootstrap samples of the blocks (percentile method: Efron & Tibshirani 1993, An
// Introduction to the Bootstrap, section 13.3). NaN if the output does not vary.
std::vector<SobolIndices> sobol_indices(int dimensions, const Eigen::VectorXd& outputs, double confidence,
                                        int resamples, std::uint64_t seed);

}  // namespace netpocket
