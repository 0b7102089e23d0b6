#pragma once
// What the steps of a system advance. Internal to this room.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/dynamics/assembly/coordinate_vectors.h"
#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/dynamics/assembly/locked_bodies.h"
#include "engine/model/model.h"

namespace netpocket {

inline CoordinateLayout layout_of(const Model& model) {
  return {static_cast<std::int32_t>(model.nodes.size()), static_cast<std::int32_t>(model.gradients.size())};
}

// World frame, SI units.
struct CableState {
  // The state in which a model begins. `mass`: lumped mass by coordinate.
  CableState(const Model& model, std::span<const double> mass);

  void advance_time(double dt) {
    time += dt;
    last_step = dt;
    ++steps;
    ++version;
  }
  // Gives every number to `visit`, which may change it. Numbers are written only where `visit` changes them, because
  // observing the state must not change a bit of the run.
  void visit_motion(const std::function<void(double&)>& visit);
  void visit_time(const std::function<void(double&)>& visit);

  // The lock that a body is held by at present; null: it moves by itself.
  const LockedBodies* lock_of(std::size_t body) const {
    for (const LockedBodies& lock : locks) {
      const auto index = static_cast<std::int32_t>(body);
      if (lock.is_locked() && (lock.carrier() == index || lock.carried() == index)) return &lock;
    }
    return nullptr;
  }

  CoordinateLayout layout;
  CoordinateVectors coordinates;  // positions and gradients at step n
  CoordinateVectors velocities;   // at n - 1/2
  std::vector<DynamicBody> bodies;
  std::vector<BodyControl> controls;  // by body, until they are changed
  std::vector<LockedBodies> locks;
  double time = 0;       // s
  double last_step = 0;  // s, size of the last step; 0: there was none
  std::int64_t steps = 0;
  // Rises whenever the motion changes, by a step or otherwise. Values derived from the state keep the version that they
  // are for, and are outdated at any other.
  std::int64_t version = 0;
};

}  // namespace netpocket
