#pragma once
// Commanded length L(t) of the closing ropes, with its first and second derivatives.

#include <vector>

#include "engine/scenario/scenario.h"

namespace netpocket {

struct ClosingState {
  double length;        // m, of the rope between adjacent rod tips
  double speed;         // m/s, dL/dt, negative while closing
  double acceleration;  // m/s^2, d2L/dt2

  friend bool operator==(const ClosingState&, const ClosingState&) = default;
};

// The rope has its open length before the start and its closed length after the end.
// In between, with s = (t - start)/duration:
//   cycloid    L = open - (open - closed) (s - sin(2 pi s)/(2 pi)): speed and acceleration vanish at both ends
//   quintic    minimum jerk, 10 s^3 - 15 s^4 + 6 s^5 (Flash & Hogan 1985)
//   trapezoid  speed rises linearly over the first quarter, is constant, and falls over the last quarter
//   linear     constant speed: the speed jumps at both ends
//   table      monotone cubic through the points (Fritsch & Carlson 1980), at rest at both ends; the speed is
//              continuous, the acceleration jumps at the points
// Speed and acceleration are the exact derivatives of the length. Immutable: safe for any number of threads.
class ClosingSchedule {
 public:
  // `open_length` in m, see open_tip_distance(). The parameters must be valid. The first length of a table is replaced
  // by the open length.
  ClosingSchedule(const ClosingParameters& parameters, double open_length);

  ClosingState at(double time) const;  // time in s

  double start() const { return start_; }            // s
  double end() const { return start_ + duration_; }  // s
  double open_length() const { return open_; }       // m
  double closed_length() const { return closed_; }   // m
  double shortest() const { return shortest_; }      // m, over all times
  double fastest() const { return fastest_; }        // m/s, largest |speed| over all times

 private:
  // A point of the table. The length between points is a cubic Hermite polynomial.
  struct Point {
    double time;    // s after the start
    double length;  // m
    double speed;   // m/s
  };

  void read_table(const std::vector<Eigen::Vector2d>& table);
  ClosingState between_points(double elapsed) const;
  double fastest_between_points() const;

  ClosingLaw law_;
  double start_;
  double duration_;
  double open_;
  double closed_;
  double shortest_;
  double fastest_;
  std::vector<Point> points_;
};

}  // namespace netpocket
