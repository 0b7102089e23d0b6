#pragma once
// A controller whose decisions come from Python: a function that is called at its own rate, or values that a script
// sets between calls of advance(). What it commanded last is held and is part of the run's state.
//
// Thread contract: update() runs on the thread of the run, without the interpreter lock; it takes the lock only to call
// the function. What the function raises leaves advance() as it is.

#include <optional>
#include <vector>

#include "engine/control/controller.h"
#include "engine/python/conversions.h"

namespace netpocket::python {

// What Python commands. Held until it is changed.
struct PythonCommands {
  struct Body {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   // N, world axes
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();  // N m, world axes
    Eigen::Vector3d point = Eigen::Vector3d::Zero();   // m, where the force acts, from the centre of mass, body axes
  };
  struct Rope {
    bool is_wound = false;
    double rate = 0;          // m/s, negative winds in
    double acceleration = 0;  // m/s^2, by which the rate follows, > 0
  };
  PythonCommands(std::size_t body_count, std::size_t rope_count) : bodies(body_count), ropes(rope_count) {}
  void visit_state(const std::function<void(double&)>& visit);

  std::vector<Body> bodies;
  std::vector<Rope> ropes;
};

// The measurements that a function of Python gets. Valid during its call; afterwards every access raises an error.
class PythonMeasurements {
 public:
  explicit PythonMeasurements(const Measurements& measurements) : measurements_(&measurements) {}
  void end() { measurements_ = nullptr; }
  const Measurements& get() const;

 private:
  const Measurements* measurements_;
};

class PythonController : public Controller {
 public:
  // `function`(measurements, interval, commands); None: nothing is called. `state`: array of numbers of the function
  // that belong to the run, or None. `period` (s): 0 calls it before every step.
  PythonController(py::object function, py::object state, double period, std::size_t bodies, std::size_t ropes)
      : function_(std::move(function)), state_(std::move(state)), period_(period), held_(bodies, ropes) {}
  ~PythonController() override;

  PythonCommands& held() { return held_; }
  void update(const Measurements& measurements, double interval, Commands& commands) override;
  void visit_state(const std::function<void(double&)>& visit) override;

 private:
  void call(const Measurements& measurements, double interval);

  py::object function_, state_;
  double period_;
  double next_call_ = 0;  // s
  PythonCommands held_;
};

}  // namespace netpocket::python
