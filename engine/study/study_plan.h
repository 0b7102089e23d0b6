#pragma once
// The points of a study, each computed from its index alone, so that a study of many points takes no memory for them
// and parts of it can run anywhere. Immutable: any thread may use it.
//
// Without uncertain inputs: for each place, the axes' grid or sample. With uncertain inputs: the draws 1, 2, ... one
// after the other, each at every place and every combination of the axes; more draws keep the old points. Draws of the
// ensemble come last.

#include <optional>
#include <span>

#include "engine/sampling/design.h"
#include "engine/study/study.h"

namespace netpocket {

// The value of an axis that is a range, in TOML syntax, at a fraction of it from 0 to 1.
std::string axis_value(const Axis& axis, double fraction);
// The inverse, for the number that a scenario has; within 0 to 1.
double axis_fraction(const Axis& axis, double value);

// The point of a study with one place and no axes at which the coordinates of the uncertain inputs in the unit cube are
// those given.
StudyPoint point_at(const Study& study, std::span<const double> fractions);

class StudyPlan {
 public:
  // The study must outlive the plan.
  explicit StudyPlan(const Study& study);

  std::size_t size() const { return regular_ + static_cast<std::size_t>(study_.ensemble.runs); }
  // 0 <= index < size().
  StudyPoint point(std::size_t index) const;

  // Number of places times combinations of the axes: how many points each draw of the uncertain inputs takes. Points
  // with the same index modulo this number differ in their draws only.
  std::size_t group_count() const { return study_.places.size() * combinations_; }
  // Number of draws of the uncertain inputs; 1 without any.
  std::size_t draw_count() const { return draws_; }

  // All draws of a study with [sensitivity], one column each; else empty.
  const Eigen::MatrixXd& design_points() const { return points_; }
  // Coordinates of a draw (from 0) in the unit cube.
  std::vector<double> fractions(std::size_t draw) const;

 private:
  std::vector<Setting> combination(std::size_t index) const;
  std::vector<Setting> sampled(std::size_t index) const;

  const Study& study_;
  std::vector<std::vector<std::string>> grid_;  // values by axis; empty when the axes are sampled
  std::vector<double> shift_;                   // of a sample of Halton points of the axes
  std::optional<Design> design_;                // of the uncertain inputs, or of the axes
  std::vector<int> steps_;                      // of a grid over the uncertain inputs
  Eigen::MatrixXd points_;                      // of a study with [sensitivity], one column per draw
  std::size_t combinations_ = 1, draws_ = 1, regular_ = 0;
};

}  // namespace netpocket
