#include "engine/control/bounded_least_squares.h"

#include <cmath>
#include <vector>

namespace netpocket {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRegularisation = 1e-8;  // of the largest square of a column
constexpr double kFlat = 1e-12;           // of the largest slope at x = 0: a smaller slope is none

double ordered_dot(const MatrixXd& a, Index i, const MatrixXd& b, Index j) {
  double sum = 0;
  for (Index row = 0; row < a.rows(); ++row) sum += a(row, i) * b(row, j);
  return sum;
}

// Solves h x = g for a positive definite h by Cholesky's decomposition.
VectorXd solve(MatrixXd h, VectorXd x) {
  const Index n = h.rows();
  for (Index j = 0; j < n; ++j) {
    for (Index k = 0; k < j; ++k) {
      for (Index i = j; i < n; ++i) h(i, j) -= h(i, k) * h(j, k);
    }
    const double pivot = std::sqrt(h(j, j));
    for (Index i = j; i < n; ++i) h(i, j) /= pivot;
  }
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < i; ++k) x[i] -= h(i, k) * x[k];
    x[i] /= h(i, i);
  }
  for (Index i = n - 1; i >= 0; --i) {
    for (Index k = i + 1; k < n; ++k) x[i] -= h(k, i) * x[k];
    x[i] /= h(i, i);
  }
  return x;
}

class ActiveSet {
 public:
  ActiveSet(const MatrixXd& a, const VectorXd& b, const VectorXd& lower, const VectorXd& upper)
      : lower_(lower), upper_(upper), h_(a.cols(), a.cols()), g_(a.cols()), x_(VectorXd::Zero(a.cols())) {
    for (Index i = 0; i < a.cols(); ++i) {
      for (Index j = 0; j < a.cols(); ++j) h_(i, j) = ordered_dot(a, i, a, j);
      g_[i] = ordered_dot(a, i, b, 0);
      free_.push_back(lower[i] < 0 && upper[i] > 0);
    }
    const double added = kRegularisation * h_.diagonal().maxCoeff();
    h_.diagonal().array() += added;
    flat_ = kFlat * g_.cwiseAbs().maxCoeff();
  }

  VectorXd solution() {
    const Index most_rounds = 4 * x_.size() + 4;
    fit();
    for (Index round = 0; round < most_rounds && free_steepest(); ++round) fit();
    return x_;
  }

 private:
  double descent(Index i) const {  // minus the slope
    double sum = g_[i];
    for (Index j = 0; j < x_.size(); ++j) sum -= h_(i, j) * x_[j];
    return sum;
  }

  // Frees the bounded variable with the steepest descent away from its bound. False: there is none.
  bool free_steepest() {
    Index steepest = -1;
    double largest = flat_;
    for (Index i = 0; i < x_.size(); ++i) {
      if (free_[i] || lower_[i] == upper_[i]) continue;
      const double inwards = x_[i] == upper_[i] ? -descent(i) : descent(i);
      if (inwards > largest) {
        largest = inwards;
        steepest = i;
      }
    }
    if (steepest >= 0) free_[steepest] = true;
    return steepest >= 0;
  }

  // The least squares of the free variables, while the others stay: by index into `indices`.
  VectorXd target(const std::vector<Index>& indices) const {
    const auto n = static_cast<Index>(indices.size());
    MatrixXd h(n, n);
    VectorXd g(n);
    for (Index i = 0; i < n; ++i) {
      g[i] = descent(indices[i]);
      for (Index j = 0; j < n; ++j) h(i, j) = h_(indices[i], indices[j]);
    }
    return solve(h, g);
  }

  // Moves the free variables to their least squares. A variable that meets a bound stays there, and the others go on.
  void fit() {
    for (;;) {
      std::vector<Index> indices;
      for (Index i = 0; i < x_.size(); ++i) {
        if (free_[i]) indices.push_back(i);
      }
      if (indices.empty()) return;
      const VectorXd change = target(indices);
      double part = 1;
      Index first = -1;
      for (std::size_t i = 0; i < indices.size(); ++i) {
        const double reach = part_to_bound(indices[i], change[static_cast<Index>(i)]);
        if (reach < part) {
          part = reach;
          first = indices[i];
        }
      }
      for (std::size_t i = 0; i < indices.size(); ++i) x_[indices[i]] += part * change[static_cast<Index>(i)];
      if (first < 0) return;
      free_[first] = false;
      x_[first] = x_[first] - lower_[first] < upper_[first] - x_[first] ? lower_[first] : upper_[first];
    }
  }

  // Part of a change of variable i at which it meets a bound.
  double part_to_bound(Index i, double change) const {
    const double room = change > 0 ? upper_[i] - x_[i] : lower_[i] - x_[i];
    return change == 0 ? 1 : room / change;
  }

  VectorXd lower_, upper_;
  MatrixXd h_;  // A^T A + r
  VectorXd g_;  // A^T b
  VectorXd x_;
  double flat_;  // descent that counts as none
  std::vector<bool> free_;
};

}  // namespace

VectorXd bounded_least_squares(const MatrixXd& a, const VectorXd& b, const VectorXd& lower, const VectorXd& upper) {
  return ActiveSet(a, b, lower, upper).solution();
}

}  // namespace netpocket
