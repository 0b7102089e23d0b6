#include "engine/dynamics/consistent_mass.h"

#include <Eigen/LU>
#include <array>
#include <stdexcept>

#include "engine/ancf/mass.h"

namespace netpocket {

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
    : row_of_slot_(layout.size(), -1), initial_mass_(mass.begin(), mass.end()) {
  const auto add_row = [&](std::int32_t slot) {
    row_of_slot_[slot] = static_cast<std::int32_t>(slot_of_row_.size());
    slot_of_row_.push_back(slot);
  };
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (model.nodes[i].support == Support::free) add_row(layout.position(static_cast<std::int32_t>(i)));
  }
  for (std::size_t i = 0; i < model.gradients.size(); ++i) {
    if (model.gradients[i].support == Support::free) add_row(layout.gradient(static_cast<std::int32_t>(i)));
  }

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
      for (int b = 0; b < 4; ++b) {
        const std::int32_t row = row_of_slot_[slot[a]], column = row_of_slot_[slot[b]];
        if (row >= 0 && column >= 0) entries.emplace_back(row, column, exchange(a, b));
      }
    }
  }
  const auto rows = static_cast<std::int32_t>(slot_of_row_.size());
  for (std::int32_t row = 0; row < rows; ++row) entries.emplace_back(row, row, mass[slot_of_row_[row]]);
  matrix_.resize(rows, rows);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(matrix_);
  if (factor_.info() != Eigen::Success) {
    throw std::invalid_argument("the mass matrix is singular: every free node and gradient must belong to an element");
  }

  for (const std::int32_t slot : changing) {
    if (row_of_slot_[slot] >= 0) changing_.push_back(slot);
  }
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(changing_.size()));
  for (std::size_t i = 0; i < changing_.size(); ++i) {
    unit(row_of_slot_[changing_[i]], static_cast<Eigen::Index>(i)) = 1;
  }
  if (!changing_.empty()) unit_response_ = factor_.solve(unit);
}

Eigen::MatrixX3d ConsistentMass::solve(const Eigen::MatrixX3d& force, std::span<const double> mass) const {
  Eigen::MatrixX3d load(slot_of_row_.size(), 3);
  for (std::size_t row = 0; row < slot_of_row_.size(); ++row) load.row(row) = force.row(slot_of_row_[row]);
  Eigen::MatrixX3d acceleration = factor_.solve(load);
  if (!changing_.empty()) {
    // (M0 + U D U^T)^-1 F = y - Z (I + D U^T Z)^-1 D U^T y, y = M0^-1 F, Z = M0^-1 U.
    const auto count = static_cast<Eigen::Index>(changing_.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count, count);
    Eigen::MatrixX3d right(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::int32_t slot = changing_[i];
      const double change = mass[slot] - initial_mass_[slot];
      system.row(i) += change * unit_response_.row(row_of_slot_[slot]);
      right.row(i) = change * acceleration.row(row_of_slot_[slot]);
    }
    acceleration -= unit_response_ * system.partialPivLu().solve(right);
  }
  Eigen::MatrixX3d result = Eigen::MatrixX3d::Zero(force.rows(), 3);
  for (std::size_t row = 0; row < slot_of_row_.size(); ++row) result.row(slot_of_row_[row]) = acceleration.row(row);
  return result;
}

double ConsistentMass::kinetic_energy(const Eigen::MatrixX3d& velocity, std::span<const double> mass) const {
  Eigen::MatrixX3d v(slot_of_row_.size(), 3);
  for (std::size_t row = 0; row < slot_of_row_.size(); ++row) v.row(row) = velocity.row(slot_of_row_[row]);
  double energy = 0.5 * v.cwiseProduct(matrix_ * v).sum();
  for (const std::int32_t slot : changing_) {
    energy += 0.5 * (mass[slot] - initial_mass_[slot]) * velocity.row(slot).squaredNorm();
  }
  return energy;
}

}  // namespace netpocket
