#pragma once
// The consistent mass matrix of a model's cables, factored once, for the full evaluation.
//
// Two kinds of elements carry lumped mass instead. The mass of variable-length elements changes in time. Elements
// attached to a rigid body would couple the factored matrix with the body's moving axes.
//
// Coordinates whose mass changes during the run (where closing ropes join the net) are eliminated last. The small
// matrix that remains for them takes their present masses and is factored anew in each solve.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/factor_kernel.h"
#include "engine/model/model.h"

namespace netpocket {

// By element: 1 if it keeps lumped mass in the full evaluation.
std::vector<std::uint8_t> lumped_elements(const Model& model);

class ConsistentMass {
 public:
  // `mass`: total lumped mass by coordinate at the start. `changing`: coordinates whose mass changes during the run.
  // Throws std::invalid_argument if the matrix is singular, as with a massless free node outside all elements.
  ConsistentMass(const Model& model, const CoordinateLayout& layout, std::span<const double> mass,
                 std::span<const std::int32_t> changing);

  // v += kick M^-1 force, x += drift v on free coordinates. `mass`: present lumped mass by coordinate. One thread at a
  // time.
  void kick_and_drift(const CoordinateVectors& force, std::span<const double> mass, double kick, double drift,
                      CoordinateVectors& v, CoordinateVectors& x);
  // Kinetic energy v.M v / 2 (J) of the free coordinates.
  double kinetic_energy(const CoordinateVectors& velocity, std::span<const double> mass) const;

 private:
  // A strictly triangular matrix, stored by rows.
  struct Triangle {
    std::vector<std::int32_t> begin = {0}, column;
    std::vector<double> value;

    template <typename Matrix>
    void set(const Matrix& matrix, Eigen::Index rows, Eigen::Index columns);
    factor_kernel::TriangleView view() const {
      return {static_cast<std::int32_t>(begin.size()) - 1, begin.data(), column.data(), value.data()};
    }
  };

  void reorder(Eigen::SparseMatrix<double>& matrix, const Eigen::PermutationMatrix<Eigen::Dynamic>& place);
  void factor(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& changes);
  void solve_last(std::span<const double> mass);
  std::int32_t first_last() const { return static_cast<std::int32_t>(coordinate_of_row_.size() - last_matrix_.rows()); }

  std::vector<std::int32_t> coordinate_of_row_;  // rows are in the order of elimination
  std::vector<std::int32_t> lone_coordinates_;   // not coupled to others: acceleration = force / mass
  std::vector<double> initial_mass_;
  Eigen::SparseMatrix<double> matrix_;  // the mass matrix, by rows as above, at the initial masses
  Triangle lower_, upper_;              // L and L^T of L D L^T, without the block of the rows eliminated last
  std::vector<double> inverse_diagonal_;
  Eigen::MatrixXd last_matrix_;  // of the rows eliminated last, at the initial masses
  std::vector<factor_kernel::Row> rows_;
};

}  // namespace netpocket
