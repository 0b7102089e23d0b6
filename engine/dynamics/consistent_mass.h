#pragma once
// The consistent mass matrix of a model's cables, factored once, for the full evaluation.
//
// Elements of variable length and those attached to a rigid body carry lumped mass instead: the first change in time,
// the second would couple the factored matrix with the body's moving axes. Slots whose mass changes during the run
// (where closing ropes join the net) are eliminated last: what is left for them is a small matrix that takes their
// present masses, factored anew in each solve.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "engine/dynamics/factor_kernel.h"
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

  // Replaces the forces on free slots by their accelerations and those on others by 0. `mass`: lumped mass by slot at
  // present. Not to be called by two threads at once.
  void solve(SlotVectors& force, std::span<const double> mass);
  // sum over free slots of v.M v / 2, J.
  double kinetic_energy(const SlotVectors& velocity, std::span<const double> mass) const;

 private:
  void factor(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& changes);
  void solve_last(std::span<const double> mass);
  std::int32_t first_last() const { return static_cast<std::int32_t>(slot_of_row_.size() - last_matrix_.rows()); }

  std::vector<std::int32_t> slot_of_row_;  // rows in the order of elimination
  std::vector<std::int32_t> lone_slots_;   // coupled to nothing: force / mass
  std::vector<std::int32_t> held_slots_;   // not free
  std::vector<double> initial_mass_;
  Eigen::SparseMatrix<double> matrix_;  // of rows
  std::vector<std::int32_t> column_begin_, row_;
  std::vector<double> value_, inverse_diagonal_;
  Eigen::MatrixXd last_matrix_;  // of the rows eliminated last, at the start's masses
  std::vector<factor_kernel::Row> rows_;
};

}  // namespace netpocket
