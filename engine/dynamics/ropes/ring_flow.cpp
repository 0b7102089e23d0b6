#include "engine/dynamics/ropes/ring_flow.h"

#include <algorithm>
#include <cmath>

namespace netpocket {
namespace {

constexpr int kIterations = 40, kHalvings = 6;
constexpr double kSettled = 1e-10;    // of the largest tension
constexpr double kNegligible = 1e-9;  // N

// A part is never taken to be shorter than half of what the rings leave it.
double taken_length(const RingLaw& law, double length) { return std::max(length, 0.5 * law.least); }

struct Pull {
  double value, slope;  // N, and its decrease with the length, N/m
};

Pull pull_of(const RingLaw& law, const RingPart& part, double length, double dt) {
  const double taken = taken_length(law, length);
  const double tension = ring_part_tension(law, part, length, dt);
  Pull pull{tension, 0};
  if (tension > 0 && length == taken) {
    pull.slope = law.stiffness * (dt > 0 ? 1 + law.damping / dt : 1) * part.distance / (taken * taken);
  }
  if (length < law.least) {
    pull.value += law.stiffness * (law.least - length) / law.least;
    pull.slope += law.stiffness / law.least;
  }
  return pull;
}

}  // namespace

// exp(x) = exp(x/64)^64, with a series for the small argument.
double capstan_ratio(double friction, double angle) {
  constexpr int kSquares = 6, kTerms = 16;
  const double x = std::clamp(friction * angle, 0.0, 50.0) / (1 << kSquares);
  double sum = 1;
  for (int term = kTerms; term > 0; --term) sum = 1 + sum * x / term;
  for (int square = 0; square < kSquares; ++square) sum *= sum;
  return sum;
}

double ring_part_strain(double distance, double length) { return std::max(distance / length - 1, 0.0); }

double ring_part_tension(const RingLaw& law, const RingPart& part, double length, double dt) {
  const double strain = ring_part_strain(part.distance, taken_length(law, length));
  const double rate = dt > 0 ? law.damping * (strain - part.strain_before) / dt : 0;
  return std::max(law.stiffness * (strain + rate), 0.0);
}

// Of the flow trial_: fills residual_ and the matrix, and returns the largest residual.
double RingFlow::residual(const RingLaw& law, std::span<const RingPart> parts, std::span<const double> ratios,
                          double dt) {
  const std::size_t rings = ratios.size();
  largest_pull_ = 0;
  for (std::size_t i = 0; i <= rings; ++i) {
    const double in = i > 0 ? trial_[i - 1] : 0, out = i < rings ? trial_[i] : 0;
    const Pull pull = pull_of(law, parts[i], parts[i].length + in - out, dt);
    pull_[i] = pull.value;
    slope_[i] = pull.slope;
    largest_pull_ = std::max(largest_pull_, pull.value);
  }
  double largest = 0;
  for (std::size_t j = 0; j < rings; ++j) {
    const double forward = pull_[j + 1] - ratios[j] * pull_[j], backward = pull_[j] - ratios[j] * pull_[j + 1];
    // Weights of the two tensions in the force that moves the rope forward.
    double of_first = 0, of_second = 0;
    if (forward > 0) {
      of_first = ratios[j];
      of_second = 1;
    } else if (backward > 0) {
      of_first = 1;
      of_second = ratios[j];
    }
    residual_[j] = law.drag / dt * trial_[j] - (of_second * pull_[j + 1] - of_first * pull_[j]);
    diagonal_[j] = law.drag / dt + of_second * slope_[j + 1] + of_first * slope_[j];
    below_[j] = -of_first * slope_[j];
    above_[j] = -of_second * slope_[j + 1];
    largest = std::max(largest, std::abs(residual_[j]));
  }
  return largest;
}

// Replaces residual_ by the Newton step. The matrix is diagonally dominant by rows.
void RingFlow::solve_tridiagonal() {
  const std::size_t n = residual_.size();
  for (std::size_t j = 1; j < n; ++j) {
    const double factor = below_[j] / diagonal_[j - 1];
    diagonal_[j] -= factor * above_[j - 1];
    residual_[j] -= factor * residual_[j - 1];
  }
  for (std::size_t j = n; j-- > 0;) {
    if (j + 1 < n) residual_[j] -= above_[j] * residual_[j + 1];
    residual_[j] /= diagonal_[j];
  }
}

std::span<const double> RingFlow::find(const RingLaw& law, std::span<const RingPart> parts,
                                       std::span<const double> ratios, double dt) {
  const std::size_t rings = ratios.size();
  flow_.assign(rings, 0.0);
  trial_ = flow_;
  for (std::vector<double>* row : {&residual_, &below_, &diagonal_, &above_}) row->resize(rings);
  pull_.resize(rings + 1);
  slope_.resize(rings + 1);
  double largest = residual(law, parts, ratios, dt);
  const auto settled = [&] { return largest <= kSettled * largest_pull_ + kNegligible; };
  for (int iteration = 0; iteration < kIterations && !settled(); ++iteration) {
    solve_tridiagonal();
    const std::vector<double>& step = change_ = residual_;
    double part = 1;
    double next = largest;
    for (int halving = 0; halving <= kHalvings; ++halving, part *= 0.5) {
      for (std::size_t j = 0; j < rings; ++j) trial_[j] = flow_[j] - part * step[j];
      next = residual(law, parts, ratios, dt);
      if (next < largest) break;
    }
    flow_ = trial_;
    largest = next;
  }
  is_settled_ = settled();
  return flow_;
}

}  // namespace netpocket
