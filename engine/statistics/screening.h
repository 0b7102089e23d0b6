#pragma once
// Screening of many inputs by Morris' method: which ones matter at all, at a few runs per input. Morris (1991),
// Factorial sampling plans for preliminary computational experiments, Technometrics 33(2),
// doi:10.1080/00401706.1991.10484804; mean absolute effect: Campolongo, Cariboni & Saltelli (2007), Environ. Model.
// Softw. 22(10), doi:10.1016/j.envsoft.2006.10.004. Pure functions: any thread may call them.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace netpocket {

// Points of the unit cube, one column each: `trajectories` walks of dimensions + 1 points, one after the other. Each
// step of a walk changes one input, each input once, in random order. An input takes the middles of `levels` equal
// cells (levels even, >= 2), so that quantiles of unbounded distributions stay finite, and a step always spans half the
// cube. More trajectories keep the old ones.
Eigen::MatrixXd screening_points(int dimensions, int trajectories, int levels, std::uint64_t seed);

// Effects of one input: differences of the output by steps of the input (1/2).
struct InputEffect {
  double mean = 0;           // mu; effects of both signs cancel
  double mean_absolute = 0;  // mu*: the rank of the input
  double deviation = 0;      // sigma: large if the effect depends on the other inputs or is not linear
  int steps = 0;             // number of differences behind it
};

// `outputs`: one per point, in their order. Steps from or to an output that is not finite are left out.
std::vector<InputEffect> screening_effects(const Eigen::MatrixXd& points, const Eigen::VectorXd& outputs);

}  // namespace netpocket
