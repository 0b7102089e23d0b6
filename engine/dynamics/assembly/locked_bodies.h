#pragma once
// Two rigid bodies that are locked to each other until a run releases them: they are stepped as one rigid body. When
// they are released, each goes on with the motion that it has, so that momentum, angular momentum and energy are kept.
// Internal to this room and to system/.

#include <functional>
#include <vector>

#include "engine/dynamics/assembly/dynamic_body.h"
#include "engine/model/model.h"

namespace netpocket {

class LockedBodies {
 public:
  // `bodies`: with their attachments, in their state at the start.
  LockedBodies(const BodyLock& lock, const Model& model, const std::vector<DynamicBody>& bodies);

  std::int32_t carrier() const { return lock_.carrier; }
  std::int32_t carried() const { return lock_.carried; }
  bool is_locked() const { return locked_; }
  void release() { locked_ = false; }

  // Steps both as DynamicBody::step does, by the wrenches on each and the control of the carrier. Returns the work (J)
  // of the control.
  double step(std::vector<DynamicBody>& bodies, const std::vector<Wrench>& wrenches, const BodyControl& control,
              double kick, double drift);
  // As DynamicBody::kinetic_energy_after, of both.
  double kinetic_energy_after(const std::vector<DynamicBody>& bodies, const std::vector<Wrench>& wrenches,
                              const BodyControl& control, double half_kick) const;
  // Gives both in `moving` the motion that they have after a kick (s) from now.
  void kick(std::vector<DynamicBody>& moving, const std::vector<Wrench>& wrenches, const BodyControl& control,
            double kick) const;

  void visit_state(const std::function<void(double&)>& visit);

 private:
  Wrench sum(const std::vector<DynamicBody>& bodies, const std::vector<Wrench>& wrenches) const;
  void place(const RigidBody& together, std::vector<DynamicBody>& bodies) const;

  struct Part {
    std::int32_t body;
    Eigen::Vector3d local;        // m, centre of mass with attachments, in the axes of the whole
    Eigen::Quaterniond attitude;  // in these axes
  };
  BodyLock lock_;
  DynamicBody together_;
  Part parts_[2];
  bool locked_ = true;
};

}  // namespace netpocket
