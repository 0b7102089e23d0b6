#pragma once
// How much rope runs through the rings of a rope without mass in one step.
//
// A part of the rope between two rings at the distance l has the natural length L. With its strain e = max(l/L - 1, 0)
// and a time step dt, over which the strain has grown from e', its tension is
//   T = max(EA (e + c (e - e')/dt), 0).
// At a ring that the rope wraps by the angle theta, rope slides only while one tension exceeds the other by more than
// the capstan's ratio R = exp(mu theta) (Euler 1769; Eytelwein 1808), towards the larger tension, at the rate f with
//   drag f = T_larger - R T_smaller.
// The small drag makes the flow a smooth function of the state. A part that has become as short as the rings allow
// gives no more: it holds its rope as if it had the additional tension k (least - L), k = EA/least.
//
// The flows of all rings are those of an implicit Euler step. With them the law is a system of monotone piecewise
// smooth equations with a tridiagonal M-matrix, solved by Newton's method. So the flow is stable however stiff the rope
// is. If the iteration does not settle, the last flow is used: rope is conserved with any flow.
//
// SI units. Thread contract: one thread at a time per object.

#include <span>
#include <vector>

namespace netpocket {

struct RingLaw {
  double stiffness;  // EA, N
  double damping;    // c, s
  double drag;       // N s/m, positive
  double least;      // m, length that a part keeps, positive
};

struct RingPart {
  double distance;       // l, m
  double length;         // L, m
  double strain_before;  // e', >= 0
};

// R = exp(mu theta), by additions and multiplications only, to 1e-13. At most exp(50): the rope is then stuck.
double capstan_ratio(double friction, double angle);

double ring_part_strain(double distance, double length);  // e
// T (N) of a part of the length `length` (m); without damping if dt = 0.
double ring_part_tension(const RingLaw& law, const RingPart& part, double length, double dt);

class RingFlow {
 public:
  // Lengths (m) that run in a step of `dt` (s) through each ring, from the part before it into the part behind it.
  // `ratios`: R by ring, one less than parts. The result is valid until the next call.
  std::span<const double> find(const RingLaw& law, std::span<const RingPart> parts, std::span<const double> ratios,
                               double dt);
  // Whether the last flow fulfils the law to round-off.
  bool is_settled() const { return is_settled_; }

 private:
  double residual(const RingLaw& law, std::span<const RingPart> parts, std::span<const double> ratios, double dt);
  void solve_tridiagonal();

  std::vector<double> flow_, trial_, change_;  // m, by ring
  std::vector<double> pull_, slope_;           // by part: T and what holds a short part, N; its decrease by L, N/m
  std::vector<double> residual_, below_, diagonal_, above_;  // of the Newton step, by ring
  double largest_pull_ = 0;
  bool is_settled_ = true;
};

}  // namespace netpocket
