#pragma once
// Wrinkling of inflated rods. Beyond the wrinkling moment their bending deviates from the linear law of the elements
// (ancf/inflated_element.h). This correction serves both evaluations. It takes few elements at a time.

#include <optional>
#include <span>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/inflated_element.h"
#include "engine/dynamics/assembly/applied_forces.h"
#include "engine/model/model.h"

namespace netpocket {

class RodWrinkling {
 public:
  // Corrects the elements of tubes. `full`: uses the curvature of the full evaluation, else that of the mean-strain
  // one.
  RodWrinkling(const Model& model, std::span<const BatchElement> elements, bool full);

  // Sets the wrinkling moment (N m) of the rods of a material from now on.
  void set_moment(std::int32_t material, double moment);
  // Infinite for materials that are no tubes.
  double moment(std::int32_t material) const;
  // Gives the wrinkling moments to `visit`, which may change them.
  void visit_state(const std::function<void(double&)>& visit);

  // Adds to `applied` the difference of the rods' forces from the linear law.
  void add_forces(const CoordinateVectors& coordinates, AppliedForces& applied) const;
  // Energy (J) minus that of the linear law, <= 0.
  double energy(const CoordinateVectors& coordinates) const;

 private:
  struct Rod {
    std::int32_t coordinate[4];
    std::int32_t material;
    double length;
    InflatedSection section;
  };
  std::optional<Softening> softening(const Rod& rod, const CoordinateVectors& coordinates) const;
  void find_whether_any_can_wrinkle();

  std::vector<Rod> rods_;
  std::vector<std::pair<std::int32_t, double>> moments_;  // of the materials of tubes: index, N m
  bool full_;
  bool can_wrinkle_ = false;  // whether any wrinkling moment is finite; if not, no time is spent here
};

}  // namespace netpocket
