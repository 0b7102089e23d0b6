#pragma once
// The consistent mass matrix of a model's cables, factored once, for the full evaluation.
//
// Elements of variable length and those attached to a rigid body carry lumped mass instead: the first change in time,
// the second would couple the factored matrix with the body's moving axes. Masses that change during the run (ropes'
// end nodes) are corrected by the Woodbury identity.

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "engine/dynamics/slot_state.h"
#include "engine/model/model.h"

namespace netpocket {

// True for elements that keep lumped mass in the full evaluation.
std::vector<std::uint8_t> lumped_elements(const Model& model);

class ConsistentMass {
 public:
  // `mass`: lumped mass by slot of everything at the start. `changing`: slots whose mass changes.
  ConsistentMass(const Model& model, const SlotLayout& layout, std::span<const double> mass,
                 std::span<const std::int32_t> changing);

  // Accelerations of all free slots from their forces; zero elsewhere. `mass`: lumped mass by slot at present.
  // One column each for x, y and z.
  Eigen::MatrixX3d solve(const Eigen::MatrixX3d& force, std::span<const double> mass) const;
  // sum over free slots of v.M v / 2, J.
  double kinetic_energy(const Eigen::MatrixX3d& velocity, std::span<const double> mass) const;

 private:
  std::vector<std::int32_t> row_of_slot_;  // -1: does not move by itself
  std::vector<std::int32_t> slot_of_row_;
  std::vector<double> initial_mass_;
  std::vector<std::int32_t> changing_;  // slots in rows
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::MatrixXd unit_response_;  // matrix^-1 U, U the unit columns of the changing slots
};

}  // namespace netpocket
