#pragma once
// Inflated rods that wrinkle: what bending beyond the wrinkling moment differs from the linear law of the elements
// (ancf/inflated_element.h), in either evaluation. A correction, for few elements at a time.

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
  // Elements of tubes, by the curvature of the full or of the mean-strain evaluation.
  RodWrinkling(const Model& model, std::span<const BatchElement> elements, bool full);

  // Wrinkling moment (N m) from now on of the rods of a material.
  void set_moment(std::int32_t material, double moment);

  // Adds to `applied` what the rods resist less than the linear law says.
  void add_forces(const CoordinateVectors& coordinates, AppliedForces& applied) const;
  // Energy less that of the linear law, <= 0. J
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
  bool full_;
  bool can_wrinkle_ = false;  // whether any moment is finite: most models spend no time here
};

}  // namespace netpocket
