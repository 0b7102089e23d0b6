#pragma once
// Lets gas out of inflated rods from an event on, at a constant rate down to a pressure that stays.

#include <functional>
#include <memory>

#include "engine/control/capture_times.h"
#include "engine/scenario/control_parameters.h"

namespace netpocket {

class Deflation {
 public:
  // `pressure`: Pa, that of the inflated rods; 0: none is known, and nothing is let out.
  Deflation(const DeflationParameters& parameters, double pressure, std::shared_ptr<const CaptureTimes> times);

  // To be called once before each step, with its beginning and length (s).
  void update(double time, double interval);
  // Adopts other parameters. What has been let out stays out, and a pressure that rises is shared out in proportion.
  void change(const DeflationParameters& parameters, double pressure);

  double part() const { return part_; }                  // of the pressure that is left, 0 to 1
  double pressure() const { return part_ * pressure_; }  // Pa
  // When the gas begins to be let out (s); infinite: not yet known, or never.
  double start() const;

  void visit_state(const std::function<void(double&)>& visit) { visit(part_); }

 private:
  DeflationParameters parameters_;
  double pressure_;  // Pa, before anything is let out
  std::shared_ptr<const CaptureTimes> times_;
  double part_ = 1;
};

}  // namespace netpocket
