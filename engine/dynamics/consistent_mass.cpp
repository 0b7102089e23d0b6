#include "engine/dynamics/consistent_mass.h"

#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "engine/ancf/instruction_set.h"
#include "engine/ancf/mass.h"

namespace netpocket {
namespace {

factor_kernel::Kernels choose_kernels() {
  using namespace factor_kernel;
  return {choose_variant(baseline::forward, avx2::forward, avx512::forward),
          choose_variant(baseline::backward, avx2::backward, avx512::backward)};
}

std::vector<std::uint8_t> free_slots(const Model& model, const SlotLayout& layout) {
  std::vector<std::uint8_t> is_free(layout.size(), 0);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    is_free[layout.position(static_cast<std::int32_t>(i))] = model.nodes[i].support == Support::free;
  }
  for (std::size_t i = 0; i < model.gradients.size(); ++i) {
    is_free[layout.gradient(static_cast<std::int32_t>(i))] = model.gradients[i].support == Support::free;
  }
  return is_free;
}

// Consistent less lumped mass of all elements, between slots.
std::vector<Eigen::Triplet<double>> mass_exchange(const Model& model, const SlotLayout& layout) {
  std::vector<Eigen::Triplet<double>> entries;
  const std::vector<std::uint8_t> lumped = lumped_elements(model);
  for (std::size_t i = 0; i < model.elements.size(); ++i) {
    if (lumped[i]) continue;
    const ModelElement& element = model.elements[i];
    const double mass_per_length = model.materials[element.material].section.mass_per_length;
    Eigen::Matrix4d exchange = consistent_mass(mass_per_length, element.length);
    exchange -= lumped_mass(mass_per_length, element.length).asDiagonal();
    const std::array<std::int32_t, 4> slot = {layout.position(element.node1), layout.gradient(element.gradient1),
                                              layout.position(element.node2), layout.gradient(element.gradient2)};
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) entries.emplace_back(slot[a], slot[b], exchange(a, b));
    }
  }
  return entries;
}

// The permutation that brings row order[i] to place i.
Eigen::PermutationMatrix<Eigen::Dynamic> places(const std::vector<int>& order) {
  Eigen::PermutationMatrix<Eigen::Dynamic> place(static_cast<Eigen::Index>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) place.indices()[order[i]] = static_cast<int>(i);
  return place;
}

// Order of elimination of a factor's first `columns` rows by level: a row's level is above those of all rows that it
// needs, which leaves the factor as it is; within a level by slot, so that rows in a row lie side by side in memory.
// The other rows stay where they are.
std::vector<int> order_by_level(const Eigen::SparseMatrix<double>& lower, Eigen::Index columns,
                                const std::vector<std::int32_t>& slot_of_row) {
  std::vector<int> level(lower.rows(), 0), order(lower.rows());
  for (Eigen::Index column = 0; column < columns; ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
      if (entry.row() != column) level[entry.row()] = std::max(level[entry.row()], level[column] + 1);
    }
  }
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.begin() + columns,
            [&](int a, int b) { return std::pair(level[a], slot_of_row[a]) < std::pair(level[b], slot_of_row[b]); });
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

ConsistentMass::ConsistentMass(const Model& model, const SlotLayout& layout, std::span<const double> mass,
                               std::span<const std::int32_t> changing)
    : initial_mass_(mass.begin(), mass.end()) {
  const std::vector<std::uint8_t> is_free = free_slots(model, layout);
  std::vector<Eigen::Triplet<double>> entries = mass_exchange(model, layout);
  std::vector<std::uint8_t> is_coupled(layout.size(), 0);
  for (const auto& entry : entries) is_coupled[entry.row()] = 1;

  std::vector<std::int32_t> row_of_slot(layout.size(), -1);
  for (std::int32_t slot = 0; slot < layout.size(); ++slot) {
    if (is_free[slot] == 0) continue;
    if (is_coupled[slot] == 0) {
      if (mass[slot] <= 0) {
        throw std::invalid_argument(
            "the mass matrix is singular: every free node and gradient must belong to an element");
      }
      lone_slots_.push_back(slot);
      continue;
    }
    row_of_slot[slot] = static_cast<std::int32_t>(slot_of_row_.size());
    slot_of_row_.push_back(slot);
  }
  const auto rows = static_cast<std::int32_t>(slot_of_row_.size());
  std::vector<Eigen::Triplet<double>> row_entries;
  for (const auto& entry : entries) {
    const std::int32_t row = row_of_slot[entry.row()], column = row_of_slot[entry.col()];
    if (row >= 0 && column >= 0) row_entries.emplace_back(row, column, entry.value());
  }
  for (std::int32_t row = 0; row < rows; ++row) row_entries.emplace_back(row, row, mass[slot_of_row_[row]]);
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(row_entries.begin(), row_entries.end());
  std::vector<std::uint8_t> changes(rows, 0);
  for (const std::int32_t slot : changing) {
    if (row_of_slot[slot] >= 0) changes[row_of_slot[slot]] = 1;
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

// Moves row i of everything by row, and of `matrix`, to place.indices()[i].
void ConsistentMass::reorder(Eigen::SparseMatrix<double>& matrix,
                             const Eigen::PermutationMatrix<Eigen::Dynamic>& place) {
  const std::vector<std::int32_t> before = slot_of_row_;
  for (Eigen::Index i = 0; i < place.size(); ++i) slot_of_row_[place.indices()[i]] = before[i];
  matrix = Eigen::SparseMatrix<double>(place * matrix * place.inverse());
}

// Keeps the factors of a matrix, and everything by row in the order of elimination: least fill first, rows that change
// last. Rows of the same level, none of which needs another's result, follow each other, so that the processor need not
// wait for one before it begins the next.
void ConsistentMass::factor(const Eigen::SparseMatrix<double>& matrix, const std::vector<std::uint8_t>& changes) {
  Eigen::PermutationMatrix<Eigen::Dynamic> least_fill;  // its inverse says which row comes when
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

  const Eigen::PermutationMatrix<Eigen::Dynamic> by_level = places(order_by_level(lower, columns, slot_of_row_));
  matrix_ = Eigen::SparseMatrix<double>(by_level * matrix_ * by_level.inverse());
  reorder(lower, by_level);
  lower_.set(Eigen::SparseMatrix<double, Eigen::RowMajor>(lower), lower.rows(), columns);
  upper_.set(lower, columns, lower.rows());
  const Eigen::VectorXd leveled = by_level * diagonal;
  for (Eigen::Index row = 0; row < columns; ++row) inverse_diagonal_.push_back(1 / leveled[row]);
  rows_.resize(slot_of_row_.size());
}

// The rows that were not eliminated, with their present masses.
void ConsistentMass::solve_last(std::span<const double> mass) {
  Eigen::MatrixXd present = last_matrix_;
  Eigen::MatrixX3d right(present.rows(), 3);
  const std::int32_t first = first_last();
  for (Eigen::Index i = 0; i < present.rows(); ++i) {
    const std::int32_t row = first + static_cast<std::int32_t>(i), slot = slot_of_row_[row];
    present(i, i) += mass[slot] - initial_mass_[slot];
    right.row(i) = Eigen::Map<const Eigen::RowVector3d>(rows_[row].value);
  }
  const Eigen::MatrixX3d solution = present.llt().solve(right);
  for (Eigen::Index i = 0; i < present.rows(); ++i) {
    Eigen::Map<Eigen::RowVector3d>(rows_[first + i].value) = solution.row(i);
  }
}

void ConsistentMass::kick_and_drift(const SlotVectors& force, std::span<const double> mass, double kick, double drift,
                                    SlotVectors& v, SlotVectors& x) {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Eigen::Vector3d f = force.get(slot_of_row_[row]);
    rows_[row] = {{f.x(), f.y(), f.z(), 0}};
  }
  static const factor_kernel::Kernels kernels = choose_kernels();
  kernels.forward(lower_.view(), rows_.data());
  if (last_matrix_.rows() > 0) solve_last(mass);
  kernels.backward(upper_.view(), inverse_diagonal_.data(), rows_.data());

  const auto move = [&](std::int32_t slot, const Eigen::Vector3d& acceleration) {
    v.add(slot, kick * acceleration);
    x.add(slot, drift * v.get(slot));
  };
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    move(slot_of_row_[row], Eigen::Vector3d::Map(rows_[row].value));
  }
  for (const std::int32_t slot : lone_slots_) move(slot, 1 / mass[slot] * force.get(slot));
}

double ConsistentMass::kinetic_energy(const SlotVectors& velocity, std::span<const double> mass) const {
  Eigen::MatrixX3d v(slot_of_row_.size(), 3);
  for (std::size_t row = 0; row < slot_of_row_.size(); ++row) v.row(row) = velocity.get(slot_of_row_[row]).transpose();
  double energy = 0.5 * v.cwiseProduct(matrix_ * v).sum();
  for (const std::int32_t slot : lone_slots_) energy += 0.5 * mass[slot] * velocity.get(slot).squaredNorm();
  for (std::size_t row = first_last(); row < slot_of_row_.size(); ++row) {
    const std::int32_t slot = slot_of_row_[row];
    energy += 0.5 * (mass[slot] - initial_mass_[slot]) * velocity.get(slot).squaredNorm();
  }
  return energy;
}

}  // namespace netpocket
