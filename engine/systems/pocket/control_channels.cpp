#include "engine/systems/pocket/control_channels.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/control/attitude_error.h"
#include "engine/control/tracking_error.h"
#include "engine/math/symmetric_algebra.h"
#include "engine/state/phase.h"

namespace netpocket {
namespace {

// Writes values to the last channels of a snapshot, one after another.
class Writer {
 public:
  Writer(Snapshot& snapshot, std::size_t count) : next_(snapshot.channels.end() - static_cast<std::ptrdiff_t>(count)) {}

  void write(double value) { *next_++ = value; }
  void write(const Eigen::Vector3d& vector) {
    for (const double component : vector) write(component);
  }

 private:
  std::vector<double>::iterator next_;
};

}  // namespace

ControlChannels::ControlChannels(ClosedLoop* loop, const WinchControl* winches, const Deflation* deflation,
                                 std::shared_ptr<const CaptureTimes> events, std::int32_t spacecraft)
    : loop_(loop), winches_(winches), deflation_(deflation), events_(std::move(events)), spacecraft_(spacecraft) {
  if (events_) add(kPhaseChannel, "1", "phase: 0 open, 1 closing, 2 closed, 3 towing, 4 after");
  if (deflation_ != nullptr) add("rod_pressure", "Pa", "pressure of the gas in the rods");
  if (loop_ != nullptr) add_loop();
  if (winches_ != nullptr) add_winches();
}

void ControlChannels::add(const std::string& name, const std::string& unit, const std::string& meaning,
                          ChannelKind kind) {
  infos_.push_back({name, unit, meaning, kind});
}

void ControlChannels::add_vector(const std::string& name, const std::string& unit, const std::string& meaning,
                                 ChannelKind kind) {
  for (const char axis : {'x', 'y', 'z'}) add(fmt::format("{}_{}", name, axis), unit, meaning, kind);
}

// In the order of `fill`.
void ControlChannels::add_loop() {
  for (const char part : {'w', 'x', 'y', 'z'}) {
    add(fmt::format("attitude_{}", part), "1", "spacecraft's attitude as quaternion, body to world axes");
  }
  add("attitude_angle", "rad", "angle by which the spacecraft is turned from the world axes");
  add_vector("spin", "rad/s", "spacecraft's angular velocity, body axes");
  add_vector("demanded_force", "N", "force that the controllers demand, world axes");
  add_vector("demanded_torque", "N m", "torque that the controllers demand, world axes");
  const char* mean = "mean over the output interval, world axes";
  add_vector("exerted_force", "N", fmt::format("force that the actuators exert, {}", mean), ChannelKind::interval);
  add_vector("exerted_torque", "N m", fmt::format("torque that the actuators exert, {}", mean), ChannelKind::interval);
  add("propellant", "kg", "propellant that the actuators have consumed so far", ChannelKind::total);
  for (std::size_t i = 0; i < loop_->actuators().momenta().size(); ++i) {
    add(fmt::format("wheel_momentum_{}", i + 1), "N m s", "momentum of a reaction wheel relative to the spacecraft");
  }
  if (!loop_->has_observer()) return;
  add_vector("disturbance_force", "N", "disturbance that observers estimate, world axes");
  add_vector("disturbance_torque", "N m", "disturbance that observers estimate, body axes");
}

void ControlChannels::add_winches() {
  const auto add_by_rope = [&](const char* name, const char* unit, const char* meaning) {
    for (std::size_t i = 0; i < winches_->winches().size(); ++i) add(fmt::format("{}_{}", name, i + 1), unit, meaning);
  };
  add_by_rope("winch_length", "m", "length of a closing rope outside its retractors");
  add_by_rope("winch_rate", "m/s", "rate of that length");
  add_by_rope("winch_torque", "N m", "torque of a winch's motor in the last step");
  add_by_rope("rope_tension", "N", "tension of a closing rope in the last step");
  add("winch_power", "W", "power of all winches' motors in the last step");
  add("winch_work", "J", "work of all winches' motors so far", ChannelKind::total);
}

void ControlChannels::fill(Snapshot& snapshot) const {
  Writer out(snapshot, infos_.size());
  if (events_) out.write(events_->phase_at(snapshot.time));
  if (deflation_ != nullptr) out.write(deflation_->pressure());
  if (loop_ != nullptr) {
    const BodyState& craft = snapshot.bodies[static_cast<std::size_t>(spacecraft_)];
    out.write(craft.attitude.w());
    out.write(Eigen::Vector3d(craft.attitude.vec()));
    out.write(symmetric_norm(rotation_vector(craft.attitude)));
    out.write(to_body_axes(craft, craft.angular_velocity));
    const ClosedLoop::Effort effort = loop_->take_effort(snapshot.time);
    out.write(effort.demanded.force);
    out.write(effort.demanded.torque);
    out.write(effort.exerted.force);
    out.write(effort.exerted.torque);
    out.write(loop_->actuators().propellant());
    for (const double momentum : loop_->actuators().momenta()) out.write(momentum);
    if (loop_->has_observer()) {
      const Wrench disturbance = loop_->disturbance();
      out.write(disturbance.force);
      out.write(disturbance.torque);
    }
  }
  if (winches_ == nullptr) return;
  const std::vector<Winch>& winches = winches_->winches();
  double power = 0, work = 0;
  for (const Winch& winch : winches) out.write(winch.motion().length);
  for (const Winch& winch : winches) out.write(winch.motion().rate);
  for (const Winch& winch : winches) out.write(winch.torque());
  for (const double tension : winches_->tensions()) out.write(tension);
  for (const Winch& winch : winches) {
    power += winch.power();
    work += winch.motor_work();
  }
  out.write(power);
  out.write(work);
}

}  // namespace netpocket
