#pragma once
// The force that cables exert on a body, as a mean over a short while: a single step would take a blow for the force.

#include <Eigen/Core>
#include <algorithm>

#include "engine/control/controller.h"
#include "engine/control/visited_numbers.h"

namespace netpocket {

// Exponential mean with a time constant of 0.02 s.
class ContactForce {
 public:
  explicit ContactForce(std::int32_t body) : body_(body) {}

  // To be called after each step of `dt` (s).
  void after_step(const Measurements& measurements, double dt) {
    constexpr double kMemory = 0.02;  // s
    const Eigen::Vector3d& impulse = measurements.contact_impulse(body_);
    force_ += std::min(1.0, dt / kMemory) * ((impulse - impulse_) / dt - force_);
    impulse_ = impulse;
  }
  const Eigen::Vector3d& force() const { return force_; }  // N, on the body, world axes

  void visit_state(const NumberVisitor& visit) {
    visit_numbers(visit, impulse_);
    visit_numbers(visit, force_);
  }

 private:
  std::int32_t body_;
  Eigen::Vector3d impulse_ = Eigen::Vector3d::Zero();  // N s, since the start
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
};

}  // namespace netpocket
