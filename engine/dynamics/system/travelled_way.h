#pragma once
// How far anything may have moved since contacts were searched for the last time. The searches are complete because
// this is measured after each step and not predicted (THEORY.md, section 6). Internal to this room.

#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/assembly/motion_bound.h"
#include "engine/dynamics/assembly/update_kernel.h"
#include "engine/dynamics/ropes/rope_dynamics.h"
#include "engine/dynamics/system/cable_elements.h"
#include "engine/dynamics/system/cable_state.h"
#include "engine/dynamics/system/system_threads.h"

namespace netpocket {

class TravelledWay {
 public:
  // All must outlive this object.
  TravelledWay(const Model& model, const CableElements& elements, const CableState& state,
               const SystemThreads& threads);

  // Upper bound (m/s) of the speed of any point of a cord at the present state.
  double cord_speed();
  // Weights of coordinates for the speeds that note_step takes (update_kernel.h).
  const double* weights() const { return bound_.weights(); }

  // To be called when a body has stepped. `before`: its pose before the step.
  struct Pose {
    Eigen::Vector3d centre, position;  // m, of the body by itself, and with its attachments
    Eigen::Quaterniond attitude;
  };
  static Pose pose_of(const DynamicBody& body);
  void note_body(std::size_t body, const Pose& before);
  // To be called after a step of `dt` (s), at the new state. `fastest`: of the free coordinates, if the step has found
  // them.
  void note_step(double dt, const std::optional<update_kernel::Fastest>& fastest);

  // Upper bounds (m) of the distance that any point of a cord, and of each body, has moved since the last call.
  struct Ways {
    double cords;
    std::vector<double> bodies;
  };
  Ways take();

 private:
  double reach_of_attachments(const DynamicBody& body) const;

  const Model& model_;
  const CableElements& elements_;
  const CableState& state_;
  const SystemThreads& threads_;
  MotionBound bound_;
  double cord_speed_ = 0;                  // m/s
  std::int64_t version_ = -1;              // of the state that cord_speed_ is for
  double cords_ = 0;                       // m
  std::vector<double> bodies_;             // m
  std::vector<double> attachments_reach_;  // m, by body
  std::vector<double> noted_rope_length_;  // m, by rope: element length at the last take()
};

}  // namespace netpocket
