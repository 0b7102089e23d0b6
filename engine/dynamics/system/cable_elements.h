#pragma once
// The elements of a system with their present lengths, the lumped masses of its coordinates, and the ropes that change
// both. Internal to this room.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ancf/element_batch.h"
#include "engine/ancf/element_coordinates.h"
#include "engine/ancf/full_batch.h"
#include "engine/ancf/material_span.h"
#include "engine/base/aligned_vector.h"
#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/tied_coordinates.h"
#include "engine/dynamics/ropes/rope_dynamics.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/model/model.h"

namespace netpocket {

// `element`: index into Model::elements.
class CableElements {
 public:
  // All must outlive this object. `ties`: of a model that is one sector; null: none.
  CableElements(const Model& model, ElementEvaluation evaluation, const TiedCoordinates* ties = nullptr);
  CableElements(const CableElements&) = delete;
  CableElements& operator=(const CableElements&) = delete;

  // Brings the lengths of elements, and masses, to the present motion of the ropes.
  void update_ropes();
  RopeDynamics& ropes() { return ropes_; }
  const RopeDynamics& ropes() const { return ropes_; }

  bool is_full() const { return evaluation_ == ElementEvaluation::full; }
  const ElementBatch& batch() const { return batch_; }
  // Powers and forces of blocks of elements, as ElementBatch::forces, with the evaluation of this system.
  BatchPower forces(int first, int last, const CoordinateVectors& coordinates, const CoordinateVectors& velocities,
                    double* rows) const;
  // As the batch takes them, with their present lengths.
  std::vector<BatchElement> batch_elements() const;

  std::int32_t coordinate(std::size_t element, int corner) const {
    return batch_.block(static_cast<int>(element / kBlockSize)).coordinate[corner][element % kBlockSize];
  }
  ElementCoordinates gather(const CoordinateVectors& vectors, std::size_t element) const;
  const CableSection& section(std::size_t element) const {
    return model_.material_of(static_cast<std::int32_t>(element)).section;
  }
  MaterialSpan span(std::size_t element) const;
  const std::vector<double>& lengths() const { return lengths_; }  // m, by element
  // By element, in whole blocks: (wave speed/length)^2, 1/s^2. 0 for lanes without an element; unpaired_rates() also
  // for elements with a strain partner.
  const double* wave_rates(int block) const { return &wave_rate_[static_cast<std::size_t>(block) * kBlockSize]; }
  const double* unpaired_rates(int block) const {
    return &unpaired_rate_[static_cast<std::size_t>(block) * kBlockSize];
  }

  // By coordinate: lumped mass (kg, kg m^2); its inverse, 0 where a coordinate is not free; the mass, likewise.
  const std::vector<double>& mass() const { return mass_; }
  const AlignedVector<double>& inverse_mass() const { return inverse_mass_; }
  const AlignedVector<double>& moving_mass() const { return moving_mass_; }

  // Loads of the model and gravity on nodes and elements, N and N m.
  CoordinateVectors constant_loads() const;

 private:
  std::vector<BatchElement> initial_elements() const;
  void set_length(std::size_t element, double length);
  void collect_mass();
  bool moves(std::int32_t coordinate) const;
  bool ends_at_strain_partner(const BatchElement& element) const;

  const Model& model_;
  const TiedCoordinates* ties_;
  ElementEvaluation evaluation_;
  CoordinateLayout layout_;
  ElementBatch batch_;
  FullBatch full_batch_;
  RopeDynamics ropes_;
  std::vector<double> lengths_;
  std::vector<double> wave_speed_;  // m/s, by material: sqrt(EA/m)
  AlignedVector<double> wave_rate_, unpaired_rate_;
  std::vector<double> mass_;
  AlignedVector<double> inverse_mass_, moving_mass_;
  std::vector<double> mass_without_ropes_;  // by entry of ropes_.massive_coordinates()
  std::vector<TiedCoordinates::Group> massive_ties_;
};

}  // namespace netpocket
