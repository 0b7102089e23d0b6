#pragma once
// Designs: points in the unit cube at which an uncertain model is run. Distributions turn their coordinates into values
// (distribution.h). Every point follows from its index alone, so that parts of a design can be computed anywhere.
// Thread contract: any number of threads may use the same design.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace netpocket {

enum class DesignKind {
  monte_carlo,      // independent points
  latin_hypercube,  // one point in each of `count` equal strata of every coordinate: McKay, Beckman & Conover (1979),
                    // Technometrics 21(2), doi:10.1080/00401706.1979.10489755
  sobol,            // scrambled Sobol sequence (sobol_sequence.h); even for counts that are powers of 2
  halton,           // shifted Halton sequence (halton_sequence.h); even for few coordinates
};

// Points with more points than asked for begin with the same points, except for the Latin hypercube: its strata depend
// on the count, so another count is another design.
class Design {
 public:
  // 1 <= dimensions <= kMostDimensions, count >= 1.
  Design(DesignKind kind, int dimensions, std::uint64_t count, std::uint64_t seed);

  int dimensions() const { return dimensions_; }
  std::uint64_t count() const { return count_; }
  // 0 <= index < count(). All coordinates lie in (0, 1).
  Eigen::VectorXd point(std::uint64_t index) const;

 private:
  double coordinate(std::uint64_t index, int axis) const;
  double stratified(std::uint64_t index, int axis) const;

  DesignKind kind_;
  int dimensions_;
  std::uint64_t count_, seed_;
};

// Largest number of coordinates of a design. For Halton fewer are advisable.
inline constexpr int kMostDimensions = 64;

// Grid of steps[0] x steps[1] x ... points, which lie in the middles of equal cells so that no coordinate is 0 or 1.
// The last coordinate changes fastest.
std::uint64_t grid_size(const std::vector<int>& steps);
Eigen::VectorXd grid_point(const std::vector<int>& steps, std::uint64_t index);

}  // namespace netpocket
