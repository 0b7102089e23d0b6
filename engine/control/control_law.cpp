#include "engine/control/control_law.h"

#include "engine/control/attitude_error.h"
#include "engine/control/attitude_pd.h"
#include "engine/control/double_loop.h"
#include "engine/control/position_pid.h"
#include "engine/control/sliding_mode_control.h"
#include "engine/control/spin_damping.h"
#include "engine/control/tow_control.h"
#include "engine/control/velocity_profile.h"
#include "engine/math/rotation.h"

namespace netpocket {
namespace {

constexpr double kNoCap = 1e30;  // N

WantedMotion wanted_attitude(const ControllerParameters& controller) {
  WantedMotion wanted;
  wanted.state.attitude = rotation_by(controller.attitude);
  return wanted;
}

Tracking attitude_tracking(const BodyState& craft, const WantedMotion& wanted) {
  return {rotation_vector(wanted.state.attitude), rotation_vector(craft.attitude),
          rotation_error(craft, wanted.state).error};
}

SlidingModeGains gains_of(const ControllerParameters& controller) {
  return {controller.slope, controller.reaching, controller.switching, controller.layer};
}

// Wrench of the target on the pocket, about the spacecraft's centre of mass: minus that of the pocket on the target.
Wrench collision(const ControllerParameters& controller, const Observed& observed) {
  Wrench wrench;
  if (!controller.feed_forward) return wrench;
  wrench.force = -observed.contact_force;
  wrench.torque = (observed.target.position - observed.craft.position).cross(wrench.force);
  return wrench;
}

class AttitudePdLaw : public ControlLaw {
 public:
  AttitudePdLaw(const ControllerParameters& c, const ControlledCraft& craft)
      : law_(attitude_gains(craft.inertia.diagonal(), c.frequency, c.damping_ratio), craft.inertia),
        wanted_(wanted_attitude(c)) {}

  Wrench update(const Observed& observed, double /*time*/, double /*dt*/) override {
    return law_.demand(observed.craft, wanted_);
  }
  Tracking tracking(const BodyState& craft, const BodyState& /*target*/, double /*time*/) const override {
    return attitude_tracking(craft, wanted_);
  }

 private:
  AttitudePd law_;
  WantedMotion wanted_;
};

class AttitudeSlidingLaw : public ControlLaw {
 public:
  AttitudeSlidingLaw(const ControllerParameters& c, const ControlledCraft& craft)
      : controller_(c), law_(gains_of(c), c.observer, craft.inertia), wanted_(wanted_attitude(c)) {}

  Wrench update(const Observed& observed, double /*time*/, double dt) override {
    return law_.update(observed.craft, wanted_, collision(controller_, observed).torque, dt);
  }
  void note_delivered(const BodyState& craft, const Wrench& exerted) override {
    law_.note_delivered(to_body_axes(craft, exerted.torque));
  }
  Tracking tracking(const BodyState& craft, const BodyState& /*target*/, double /*time*/) const override {
    return attitude_tracking(craft, wanted_);
  }
  Wrench disturbance() const override { return {Eigen::Vector3d::Zero(), law_.disturbance()}; }
  void visit_state(const NumberVisitor& visit) override { law_.visit_state(visit); }

 private:
  ControllerParameters controller_;
  AttitudeSlidingMode law_;
  WantedMotion wanted_;
};

class DoubleLoopLaw : public ControlLaw {
 public:
  DoubleLoopLaw(const ControllerParameters& c, const ControlledCraft& craft)
      : law_({.slope = c.slope,
              .outer_switching = c.outer_switching,
              .outer_layer = c.outer_layer,
              .fastest = c.fastest,
              .inner = gains_of(c),
              .observer_bandwidth = c.observer},
             craft.inertia),
        wanted_(wanted_attitude(c)) {}

  Wrench update(const Observed& observed, double /*time*/, double dt) override {
    return law_.update(observed.craft, wanted_, dt);
  }
  void note_delivered(const BodyState& craft, const Wrench& exerted) override {
    law_.note_delivered(to_body_axes(craft, exerted.torque));
  }
  Tracking tracking(const BodyState& craft, const BodyState& /*target*/, double /*time*/) const override {
    return attitude_tracking(craft, wanted_);
  }
  Wrench disturbance() const override { return {Eigen::Vector3d::Zero(), law_.disturbance()}; }
  void visit_state(const NumberVisitor& visit) override { law_.visit_state(visit); }

 private:
  DoubleLoop law_;
  WantedMotion wanted_;
};

// A law of the position, along the axes of the controller.
class PositionLaw : public ControlLaw {
 public:
  PositionLaw(const ControllerParameters& c, const ControlledCraft& craft) : controller_(c), start_(craft.position) {}

  // A component that is not controlled counts as it is.
  Tracking tracking(const BodyState& craft, const BodyState& /*target*/, double time) const override {
    const Eigen::Vector3d error = position_error(craft, wanted(time).state).error;
    const Eigen::Vector3d controlled = along_axes({error, Eigen::Vector3d::Zero()}).force;
    return {craft.position - controlled, craft.position, controlled};
  }

 protected:
  WantedMotion wanted(double time) const {
    WantedMotion wanted;
    wanted.state.position = start_ + controller_.position + time * controller_.velocity;
    wanted.state.velocity = controller_.velocity;
    return wanted;
  }
  Wrench along_axes(Wrench demand) const {
    if (controller_.axes == ControlledAxes::lateral) demand.force.y() = 0;
    if (controller_.axes == ControlledAxes::axial) demand.force.x() = demand.force.z() = 0;
    return demand;
  }

  ControllerParameters controller_;

 private:
  Eigen::Vector3d start_;
};

class PositionPdLaw : public PositionLaw {
 public:
  PositionPdLaw(const ControllerParameters& c, const ControlledCraft& craft)
      : PositionLaw(c, craft), law_(axes(c, craft.mass), craft.mass) {}

  Wrench update(const Observed& observed, double time, double dt) override {
    return along_axes(law_.update(observed.craft, wanted(time), dt));
  }
  void visit_state(const NumberVisitor& visit) override { law_.visit_state(visit); }

 private:
  static std::array<PidSettings, 3> axes(const ControllerParameters& c, double mass) {
    const PidSettings axis{.proportional = mass * c.frequency * c.frequency,
                           .derivative = 2 * c.damping_ratio * mass * c.frequency};
    return {axis, axis, axis};
  }

  PositionPid law_;
};

class PositionSlidingLaw : public PositionLaw {
 public:
  PositionSlidingLaw(const ControllerParameters& c, const ControlledCraft& craft)
      : PositionLaw(c, craft), law_(gains_of(c), c.observer, craft.mass) {}

  Wrench update(const Observed& observed, double time, double dt) override {
    return along_axes(law_.update(observed.craft, wanted(time), collision(controller_, observed).force, dt));
  }
  void note_delivered(const BodyState& /*craft*/, const Wrench& exerted) override {
    law_.note_delivered(exerted.force);
  }
  Wrench disturbance() const override { return {law_.disturbance(), Eigen::Vector3d::Zero()}; }
  void visit_state(const NumberVisitor& visit) override { law_.visit_state(visit); }

 private:
  PositionSlidingMode law_;
};

// Towing towards -Y.
class TowLaw : public ControlLaw {
 public:
  TowLaw(const ControllerParameters& c, const ControlledCraft& craft)
      : controller_(c),
        mass_(craft.captured_mass),
        law_({.proportional = c.proportional, .integral = c.integral, .derivative = c.derivative},
             TensionCapSettings{.cap = c.most_tension > 0 ? c.most_tension : kNoCap}) {}

  Wrench update(const Observed& observed, double time, double dt) override {
    const bool speed = controller_.quantity == TowQuantity::speed;
    const BodyState &craft = observed.craft, &target = observed.target;
    const double value = value_of(craft, target);
    const double rate = speed ? 0 : target.velocity.y() - craft.velocity.y();
    if (!begun_) {
      begun_ = true;
      start_ = time;
      from_ = value;
    }
    const VelocityProfile profile = wanted_profile();
    const double growth = profile.acceleration(time);
    const TowReference wanted{profile.velocity(time), speed ? 0 : growth, speed ? mass_ * growth : 0};
    const double thrust = law_.update({value, rate, -observed.contact_force.y()}, wanted, dt);
    return {{0, -thrust, 0}, Eigen::Vector3d::Zero()};
  }
  // Before it begins, it wants what there is.
  Tracking tracking(const BodyState& craft, const BodyState& target, double time) const override {
    const double value = value_of(craft, target);
    const double wanted = begun_ ? wanted_profile().velocity(time) : value;
    return {{wanted, 0, 0}, {value, 0, 0}, {value - wanted, 0, 0}};
  }
  void restart() override { begun_ = false; }
  void visit_state(const NumberVisitor& visit) override {
    visit_flag(visit, begun_);
    visit(start_);
    visit(from_);
    law_.visit_state(visit);
  }

 private:
  double value_of(const BodyState& craft, const BodyState& target) const {
    if (controller_.quantity == TowQuantity::speed) return -craft.velocity.y();
    return target.position.y() - craft.position.y();
  }
  VelocityProfile wanted_profile() const { return {start_, controller_.ramp, from_, controller_.wanted}; }

  ControllerParameters controller_;
  double mass_;
  TowControl law_;
  bool begun_ = false;
  double start_ = 0, from_ = 0;  // s and value at which the ramp begins
};

class SpinDampingLaw : public ControlLaw {
 public:
  explicit SpinDampingLaw(const ControllerParameters& c) : law_{.gain = c.damping, .most = c.most_torque} {}

  Wrench update(const Observed& observed, double /*time*/, double /*dt*/) override {
    return law_.demand(observed.craft.angular_velocity);
  }
  Tracking tracking(const BodyState& craft, const BodyState& /*target*/, double /*time*/) const override {
    return {Eigen::Vector3d::Zero(), craft.angular_velocity, craft.angular_velocity};
  }

 private:
  SpinDamping law_;
};

}  // namespace

std::unique_ptr<ControlLaw> control_law(const ControllerParameters& controller, const ControlledCraft& craft) {
  switch (controller.kind) {
    case ControllerKind::attitude_pd:
      return std::make_unique<AttitudePdLaw>(controller, craft);
    case ControllerKind::attitude_sliding_mode:
      return std::make_unique<AttitudeSlidingLaw>(controller, craft);
    case ControllerKind::attitude_double_loop:
      return std::make_unique<DoubleLoopLaw>(controller, craft);
    case ControllerKind::position_pd:
      return std::make_unique<PositionPdLaw>(controller, craft);
    case ControllerKind::position_sliding_mode:
      return std::make_unique<PositionSlidingLaw>(controller, craft);
    case ControllerKind::tow:
      return std::make_unique<TowLaw>(controller, craft);
    case ControllerKind::spin_damping:
      break;
  }
  return std::make_unique<SpinDampingLaw>(controller);
}

}  // namespace netpocket
