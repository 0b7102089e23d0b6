#pragma once
// The length of the closing ropes as the retractors command it: L(t) with its first and second derivative.

#include <vector>

#include "engine/scenario/scenario.h"

namespace netpocket {

struct ClosingState {
  double length;        // m, rope between adjacent rod tips
  double speed;         // m/s, dL/dt, negative while closing
  double acceleration;  // m/s^2, d2L/dt2

  friend bool operator==(const ClosingState&, const ClosingState&) = default;
};

// Open before the start, closed after the end, and between them, with s = (t - start)/duration,
//   cycloid    L = open - (open - closed) (s - sin(2 pi s)/(2 pi)): speed and acceleration vanish at both ends
//   quintic    minimum jerk, 10 s^3 - 15 s^4 + 6 s^5 (Flash & Hogan 1985)
//   trapezoid  speed rises linearly over the first quarter, is constant, and falls over the last quarter
//   linear     constant speed: the speed jumps at both ends
//   table      monotone cubic through the points (Fritsch & Carlson 1980), at rest at both ends; the speed is
//   continuous,
//              the acceleration jumps at the points
// Speed and acceleration are the exact derivatives of the length. Immutable: any thread may use it.
class ClosingSchedule {
 public:
  // `open_length` in m, see open_tip_distance(). The parameters must be valid; the first length of a table is replaced
  // by the open length.
  ClosingSchedule(const ClosingParameters& parameters, double open_length);

  ClosingState at(double time) const;  // time in s

  double start() const { return start_; }            // s
  double end() const { return start_ + duration_; }  // s
  double open_length() const { return open_; }       // m
  double closed_length() const { return closed_; }   // m
  double shortest() const { return shortest_; }      // m, at any time
  double fastest() const { return fastest_; }        // m/s, largest size of the speed at any time

 private:
  // A point of the table: cubic Hermite between points.
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
