#include "engine/dynamics/assembly/consistent_mass.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "engine/ancf/mass.h"
#include "engine/math/instruction_set.h"

namespace netpocket {
namespace {

factor_kernel::Kernels choose_kernels() {
  using namespace factor_kernel;
  return {NETPOCKET_VARIANT_OF(factor_kernel, forward), NETPOCKET_VARIANT_OF(factor_kernel, backward)};
}

std::vector<std::uint8_t> free_coordinates(const Model& model, const CoordinateLayout& layout) {
  std::vector<std::uint8_t> is_free(layout.size(), 0);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    is_free[layout.position(static_cast<std::int32_t>(i))] = model.nodes[i].support == Support::free;
  }
  for (std::size_t i = 0; i < model.gradients.size(); ++i) {
    is_free[layout.gradient(static_cast<std::int32_t>(i))] = model.gradients[i].support == Support::free;
  }
  return is_free;
}

// Consistent minus lumped mass of all elements that are not lumped, as entries between coordinates.
std::vector<Eigen::Triplet<double>> mass_exchange(const Model& model, const CoordinateLayout& layout) {
  std::vector<Eigen::Triplet<double>> entries;
  const std::vector<std::uint8_t> lumped = lumped_elements(model);
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    if (lumped[i]) continue;
    const ModelElement& element = model.elements[i];
    const double mass_per_length = model.materials[element.material].section.mass_per_length;
    Eigen::Matrix4d exchange = consistent_mass(mass_per_length, element.length);
    exchange -= lumped_mass(mass_per_length, element.length).asDiagonal();
    const std::array<std::int32_t, 4> coordinate = {layout.position(element.node1), layout.gradient(element.gradient1),
                                                    layout.position(element.node2), layout.gradient(element.gradient2)};
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) entries.emplace_back(coordinate[a], coordinate[b], exchange(a, b));
    }
  }
  return entries;
}

// The permutation that moves row order[i] to place i.
Eigen::PermutationMatrix<Eigen::Dynamic> places(const std::vector<int>& order) {
  Eigen::PermutationMatrix<Eigen::Dynamic> place(static_cast<Eigen::Index>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) place.indices()[order[i]] = static_cast<int>(i);
  return place;
}

// Orders the first `columns` rows of a factor by level. The level of a row is above the levels of all rows that it
// depends on, so the factor's values do not change. Within a level rows are sorted by coordinate, so that neighbours
// are close in memory. The other rows keep their places.
std::vector<int> order_by_level(const Eigen::SparseMatrix<double>& lower, Eigen::Index columns,
                                const std::vector<std::int32_t>& coordinate_of_row) {
  std::vector<int> level(lower.rows(), 0), order(lower.rows());
  for (Eigen::Index column = 0; column < columns; ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
      if (entry.row() != column) level[entry.row()] = std::max(level[entry.row()], level[column] + 1);
    }
  }
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.begin() + columns, [&](int a, int b) {
    return std::pair(level[a], coordinate_of_row[a]) < std::pair(level[b], coordinate_of_row[b]);
  });
  return order;
}

}  // namespace

std::vector<std::uint8_t> lumped_elements(const Model& model) {
  std::vector<std::uint8_t> lumped(model.elements.size(), 0);
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    const ModelElement& element = model.elements[i];
    lumped[i] =
        model.nodes[element.node1].support == Support::body || model.nodes[element.node2].support == Support::body;
  }
  for (const VariableRope& rope : model.ropes) {
    for (const std::int32_t element : rope.elements) lumped[element] = 1;
  }
  return lumped;
}

ConsistentMass::ConsistentMass(const Model& model, const CoordinateLayout& layout, std::span<const double> mass,
                               std::span<const std::int32_t> changing)
    : initial_mass_(mass.begin(), mass.end()) {
  const std::vector<std::uint8_t> is_free = free_coordinates(model, layout);
  std::vector<Eigen::Triplet<double>> entries = mass_exchange(model, layout);
  std::vector<std::uint8_t> is_coupled(layout.size(), 0);
  for (const auto& entry : entries) is_coupled[entry.row()] = 1;

  std::vector<std::int32_t> row_of_coordinate(layout.size(), -1);
  for (std::int32_t coordinate = 0; coordinate < layout.size(); ++coordinate) {
    if (is_free[coordinate] == 0) continue;
    if (is_coupled[coordinate] == 0) {
      if (mass[coordinate] <= 0) {
        throw std::invalid_argument(
            "the mass matrix is singular: every free node and gradient must belong to an element");
      }
      lone_coordinates_.push_back(coordinate);
      continue;
    }
    row_of_coordinate[coordinate] = static_cast<std::int32_t>(coordinate_of_row_.size());
    coordinate_of_row_.push_back(coordinate);
  }
  const auto rows = static_cast<std::int32_t>(coordinate_of_row_.size());
  std::vector<Eigen::Triplet<double>> row_entries;
  for (const auto& entry : entries) {
    const std::int32_t row = row_of_coordinate[entry.row()], column = row_of_coordinate[entry.col()];
    if (row >= 0 && column >= 0) row_entries.emplace_back(row, column, entry.value());
  }
  for (std::int32_t row = 0; row < rows; ++row) row_entries.emplace_back(row, row, mass[coordinate_of_row_[row]]);
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(row_entries.begin(), row_entries.end());
  std::vector<std::uint8_t> changes(rows, 0);
  for (const std::int32_t coordinate : changing) {
    if (row_of_coordinate[coordinate] >= 0) changes[row_of_coordinate[coordinate]] = 1;
  }
  factor(matrix, changes);
}

template <typename Matrix>
void ConsistentMass::Triangle::set(const Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  for (Eigen::Index row = 0; row < rows; ++row) {
    for (typename Matrix::InnerIterator entry(matrix, row); entry; ++entry) {
      if (entry.index() == row || entry.index() >= columns) continue;
      column.push_back(static_cast<std::int32_t>(entry.index()));
      value.push_back(entry.value());
    }
    begin.push_back(static_cast<std::int32_t>(column.size()));
  }
}

// Moves row i of `matrix` and of coordinate_of_row_ to place.indices()[i].
void ConsistentMass::reorder(Eigen::SparseMatrix<double>& matrix,
                             const Eigen::PermutationMatrix<Eigen::Dynamic>& place) {
  const std::vector<std::int32_t> before = coordinate_of_row_;
  for (Eigen::Index i = 0; i < place.size(); ++i) coordinate_of_row_[place.indices()[i]] = before[i];
  matrix = Eigen::SparseMatrix<double>(place * matrix * place.inverse());
}

// Stores the factors of a matrix, with rows in the order of elimination: least fill first, changing rows last. Rows of
// one level do not depend on each other and are adjacent, so that the processor need not wait for one before it begins
// the next.
void ConsistentMass::factor(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& changes) {
  Eigen::PermutationMatrix<Eigen::Dynamic> least_fill;  // its inverse gives the order of rows
  Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), least_fill);
  std::vector<int> order(least_fill.indices().begin(), least_fill.indices().end());
  const auto last = std::stable_partition(order.begin(), order.end(), [&](int row) { return changes[row] == 0; });
  const Eigen::Index last_count = order.end() - last, columns = matrix.cols() - last_count;
  matrix_ = matrix;
  reorder(matrix_, places(order));

  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt(matrix_);
  if (ldlt.info() != Eigen::Success || (ldlt.vectorD().array() <= 0).any()) {
    throw std::invalid_argument("the mass matrix is singular: every free node and gradient must belong to an element");
  }
  Eigen::SparseMatrix<double> lower = ldlt.matrixL();
  const Eigen::VectorXd diagonal = ldlt.vectorD();
  const Eigen::MatrixXd corner =
      Eigen::MatrixXd(lower.bottomRightCorner(last_count, last_count)).triangularView<Eigen::UnitLower>();
  last_matrix_ = corner * diagonal.tail(last_count).asDiagonal() * corner.transpose();

  const Eigen::PermutationMatrix<Eigen::Dynamic> by_level = places(order_by_level(lower, columns, coordinate_of_row_));
  matrix_ = Eigen::SparseMatrix<double>(by_level * matrix_ * by_level.inverse());
  reorder(lower, by_level);
  lower_.set(Eigen::SparseMatrix<double, Eigen::RowMajor>(lower), lower.rows(), columns);
  upper_.set(lower, columns, lower.rows());
  const Eigen::VectorXd leveled = by_level * diagonal;
  for (Eigen::Index row = 0; row < columns; ++row) inverse_diagonal_.push_back(1 / leveled[row]);
  rows_.resize(coordinate_of_row_.size());
}

// Solves for the rows that were not eliminated, with their present masses.
void ConsistentMass::solve_last(std::span<const double> mass) {
  Eigen::MatrixXd present = last_matrix_;
  Eigen::MatrixX3d right(present.rows(), 3);
  const std::int32_t first = first_last();
  for (Eigen::Index i = 0; i < present.rows(); ++i) {
    const std::int32_t row = first + static_cast<std::int32_t>(i), coordinate = coordinate_of_row_[row];
    present(i, i) += mass[coordinate] - initial_mass_[coordinate];
    right.row(i) = Eigen::Map<const Eigen::RowVector3d>(rows_[row].value);
  }
  const Eigen::MatrixX3d solution = present.llt().solve(right);
  for (Eigen::Index i = 0; i < present.rows(); ++i) {
    Eigen::Map<Eigen::RowVector3d>(rows_[first + i].value) = solution.row(i);
  }
}

void ConsistentMass::kick_and_drift(const CoordinateVectors& force, std::span<const double> mass, double kick,
                                    double drift, CoordinateVectors& v, CoordinateVectors& x) {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Eigen::Vector3d f = force.get(coordinate_of_row_[row]);
    rows_[row] = {{f.x(), f.y(), f.z(), 0}};
  }
  static const factor_kernel::Kernels kernels = choose_kernels();
  kernels.forward(lower_.view(), rows_.data());
  if (last_matrix_.rows() > 0) solve_last(mass);
  kernels.backward(upper_.view(), inverse_diagonal_.data(), rows_.data());

  const auto move = [&](std::int32_t coordinate, const Eigen::Vector3d& acceleration) {
    v.add(coordinate, kick * acceleration);
    x.add(coordinate, drift * v.get(coordinate));
  };
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    move(coordinate_of_row_[row], Eigen::Vector3d::Map(rows_[row].value));
  }
  for (const std::int32_t coordinate : lone_coordinates_)
    move(coordinate, 1 / mass[coordinate] * force.get(coordinate));
}

double ConsistentMass::kinetic_energy(const CoordinateVectors& velocity, std::span<const double> mass) const {
  Eigen::MatrixX3d v(coordinate_of_row_.size(), 3);
  for (std::size_t row = 0; row < coordinate_of_row_.size(); ++row)
    v.row(row) = velocity.get(coordinate_of_row_[row]).transpose();
  double energy = 0.5 * v.cwiseProduct(matrix_ * v).sum();
  for (const std::int32_t coordinate : lone_coordinates_)
    energy += 0.5 * mass[coordinate] * velocity.get(coordinate).squaredNorm();
  for (std::size_t row = first_last(); row < coordinate_of_row_.size(); ++row) {
    const std::int32_t coordinate = coordinate_of_row_[row];
    energy += 0.5 * (mass[coordinate] - initial_mass_[coordinate]) * velocity.get(coordinate).squaredNorm();
  }
  return energy;
}

}  // namespace netpocket
