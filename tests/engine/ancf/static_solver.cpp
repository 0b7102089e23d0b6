#include "static_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace netpocket::test {
namespace {

// Coordinates of the chain: columns r, g of each node in turn. Element i has the columns 2i to 2i + 3.
using Nodes = Eigen::Matrix<double, 3, Eigen::Dynamic>;

ElementCoordinates element_coordinates(const Nodes& nodes, int element) { return nodes.middleCols<4>(2 * element); }

class Equilibrium {
 public:
  Equilibrium(const StaticChain& chain, Nodes& nodes) : chain_(chain), nodes_(nodes) {
    // The clamp holds the first position and the direction of the first gradient, not its length; z is left out.
    unknowns_.resize(1 + 2 * (nodes.cols() - 2));
    unknowns_[0] = 3;
    for (Eigen::Index column = 2; column < nodes.cols(); ++column) {
      unknowns_.segment<2>(2 * column - 3) << 3 * column, 3 * column + 1;
    }
  }

  // Newton iterations down to round-off: far from the solution the energy must fall, close to it (where round-off hides
  // the energy's fall) steps must become smaller.
  void iterate(const TipLoad& load, StaticResult& result) {
    constexpr double kClose = 1e-6;
    double last_step = std::numeric_limits<double>::max();
    for (int i = 0; i < 200; ++i, ++result.iterations) {
      const Eigen::VectorXd unbalanced = residual(load);
      result.residual = unbalanced.norm() / largest_force_;
      const Eigen::VectorXd step = downhill(stiffness(load), unbalanced);
      const double size = step.lpNorm<Eigen::Infinity>();
      if (size > kClose) {
        descend(load, step);
      } else if (size < last_step / 2) {
        move(step);
      } else {
        return;
      }
      last_step = size;
    }
  }

 private:
  double potential(const Nodes& nodes, const Nodes& reference, const TipLoad& load) const {
    double energy = -load.force.dot(nodes.col(nodes.cols() - 2));
    // The moment's work is measured from the reference, less than half a turn away.
    const Eigen::Vector3d from = reference.rightCols<1>(), to = nodes.rightCols<1>();
    energy -= load.moment * std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    for (int i = 0; i < chain_.elements; ++i) energy += chain_.element.energy(element_coordinates(nodes, i));
    return energy;
  }

  Eigen::VectorXd residual(const TipLoad& load) {
    Nodes force = Nodes::Zero(3, nodes_.cols());
    largest_force_ = 0;
    for (int i = 0; i < chain_.elements; ++i) {
      const ElementCoordinates internal = chain_.element.force(element_coordinates(nodes_, i));
      force.middleCols<4>(2 * i) -= internal;
      largest_force_ = std::max(largest_force_, internal.norm());
    }
    const Eigen::Vector3d g = nodes_.rightCols<1>();
    force.col(force.cols() - 2) += load.force;
    force.rightCols<1>() += load.moment / g.squaredNorm() * Eigen::Vector3d(-g.y(), g.x(), 0);
    return force.reshaped()(unknowns_);
  }

  Eigen::MatrixXd stiffness(const TipLoad& load) const {
    Eigen::MatrixXd full = Eigen::MatrixXd::Zero(nodes_.size(), nodes_.size());
    for (int i = 0; i < chain_.elements; ++i) {
      full.block<12, 12>(6 * i, 6 * i) += chain_.element.tangent(element_coordinates(nodes_, i));
    }
    // - d(moment's force)/dg, the Hessian of -moment * angle.
    const Eigen::Vector3d g = nodes_.rightCols<1>();
    const double x = g.x(), y = g.y(), scale = load.moment / std::pow(g.squaredNorm(), 2);
    Eigen::Matrix2d turning;
    turning << -2 * x * y, x * x - y * y, x * x - y * y, 2 * x * y;
    full.block<2, 2>(full.rows() - 3, full.rows() - 3) += scale * turning;

    return full(unknowns_, unknowns_);
  }

  void move(const Eigen::VectorXd& step) { nodes_.reshaped()(unknowns_) += step; }

  // Halves the step until the energy falls.
  void descend(const TipLoad& load, const Eigen::VectorXd& step) {
    const Nodes start = nodes_;
    const double before = potential(start, start, load);
    for (double fraction = 1; fraction > 1e-6; fraction /= 2) {
      nodes_ = start;
      move(fraction * step);
      if (potential(nodes_, start, load) <= before) return;
    }
  }

  // Newton's step, with a diagonal added until the stiffness is positive definite, so that it leads downhill.
  static Eigen::VectorXd downhill(const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& force) {
    for (double shift = 0;; shift = std::max(10 * shift, 1e-10)) {
      Eigen::MatrixXd shifted = stiffness;
      shifted.diagonal() += shift * stiffness.diagonal().cwiseAbs();
      const Eigen::LLT<Eigen::MatrixXd> factors(shifted);
      if (factors.info() == Eigen::Success) return factors.solve(force);
    }
  }

  const StaticChain& chain_;
  Nodes& nodes_;
  Eigen::VectorX<Eigen::Index> unknowns_;  // of nodes_.data()
  double largest_force_ = 0;
};

Nodes straight_nodes(const StaticChain& chain) {
  Nodes nodes = Nodes::Zero(3, 2 * (chain.elements + 1));
  for (int i = 0; i <= chain.elements; ++i) {
    nodes(0, 2 * i) = chain.length * i / chain.elements;
    nodes(0, 2 * i + 1) = 1;
  }
  return nodes;
}

}  // namespace

StaticResult solve(const StaticChain& chain, const TipLoad& load, int load_steps) {
  Nodes nodes = straight_nodes(chain);
  StaticResult result;
  for (int i = 1; i <= load_steps; ++i) {
    const double fraction = static_cast<double>(i) / load_steps;
    Equilibrium(chain, nodes).iterate({fraction * load.force, fraction * load.moment}, result);
  }
  for (int i = 0; i < chain.elements; ++i) result.coordinates.push_back(element_coordinates(nodes, i));
  return result;
}

}  // namespace netpocket::test
