#include "engine/systems/pocket/loop_channels.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/scenario/check_control.h"

namespace netpocket {
namespace {

constexpr const char* kStateMeaning = "state: 0 waiting, 1 active, 2 over, 3 off, 4 jammed";

std::vector<std::string> by_axis(const std::string& name) { return {name + "_x", name + "_y", name + "_z"}; }

// What a controller is called, what it controls, and in which unit.
struct Words {
  const char *name, *quantity, *unit;
};

Words words_of(const ControllerParameters& controller) {
  switch (controller.kind) {
    case ControllerKind::attitude_pd:
      return {"Attitude PD", "attitude", "rad"};
    case ControllerKind::attitude_sliding_mode:
      return {"Attitude sliding mode", "attitude", "rad"};
    case ControllerKind::attitude_double_loop:
      return {"Attitude double loop", "attitude", "rad"};
    case ControllerKind::position_pd:
      return {"Position PD", "position", "m"};
    case ControllerKind::position_sliding_mode:
      return {"Position sliding mode", "position", "m"};
    case ControllerKind::tow:
      break;
    case ControllerKind::spin_damping:
      return {"Spin damping", "angular velocity", "rad/s"};
  }
  return controller.quantity == TowQuantity::speed ? Words{"Tow", "speed", "m/s"} : Words{"Tow", "separation", "m"};
}

struct DriveWords {
  const char *quantity, *unit, *actual;  // the channel's name begins so
};

DriveWords words_of(WinchDrive drive) {
  switch (drive) {
    case WinchDrive::rate:
      return {"rate", "m/s", "winch_rate"};
    case WinchDrive::tension:
      return {"tension", "N", "rope_tension"};
    case WinchDrive::torque:
      return {"torque", "N m", "winch_torque"};
    case WinchDrive::length:
    case WinchDrive::prescribed:
      break;
  }
  return {"length", "m", "winch_length"};
}

// The name, with a number where there are several.
std::string unique_name(const std::string& name, const std::vector<ControlLoopInfo>& loops) {
  const auto is_taken = [&](const std::string& n) {
    return std::ranges::any_of(loops, [&](const ControlLoopInfo& loop) { return loop.name == n; });
  };
  std::string unique = name;
  for (int i = 2; is_taken(unique); ++i) unique = fmt::format("{} {}", name, i);
  return unique;
}

// Writes values to the channels that follow the known ones, one after another.
class LoopWriter {
 public:
  explicit LoopWriter(Snapshot& snapshot)
      : next_(snapshot.channels.begin() + static_cast<std::ptrdiff_t>(kKnownChannelCount)) {}

  void write(double value) { *next_++ = value; }
  void write(LoopState state) { write(static_cast<double>(state)); }
  void write(const Eigen::Vector3d& vector) {
    for (const double component : vector) write(component);
  }

 private:
  std::vector<double>::iterator next_;
};

}  // namespace

LoopChannels::LoopChannels(const Scenario& scenario, const ClosedLoop* loop, const WinchControl* winches,
                           Disturbances* disturbances, std::int32_t spacecraft, std::int32_t target)
    : loop_(loop), winches_(winches), disturbances_(disturbances), spacecraft_(spacecraft), target_(target) {
  const bool has_any = loop != nullptr || winches != nullptr || !scenario.disturbances.empty();
  if (!has_any) disturbances_ = nullptr;
  if (loop_ != nullptr) add_loads();
  if (loop_ != nullptr) add_controllers(scenario.controllers);
  if (winches_ != nullptr) add_winches(scenario.winch.drive);
  if (disturbances_ != nullptr) add_disturbances();
}

LoopChannels::Names LoopChannels::add(const std::string& name, const std::string& unit, const std::string& meaning,
                                      ChannelKind kind) {
  infos_.push_back({name, unit, meaning, kind});
  return {name};
}

LoopChannels::Names LoopChannels::add_vector(const std::string& name, const std::string& unit,
                                             const std::string& meaning, ChannelKind kind) {
  for (const std::string& component : by_axis(name)) add(component, unit, meaning, kind);
  return by_axis(name);
}

void LoopChannels::add_loads() {
  const std::string meaning = " last demanded, by what the actuators can give; 1 or more: saturated";
  if (loop_->actuators().limits_force()) add("force_load", "1", "force" + meaning);
  if (loop_->actuators().limits_torque()) add("torque_load", "1", "torque" + meaning);
}

// In the order of `fill`.
void LoopChannels::add_controllers(const std::vector<ControllerParameters>& controllers) {
  const ActuatorSet& actuators = loop_->actuators();
  for (std::size_t i = 0; i < controllers.size(); ++i) {
    const ControllerParameters& controller = controllers[i];
    const Words words = words_of(controller);
    const bool scalar = controller.kind == ControllerKind::tow;
    const bool torque = is_of_attitude(controller.kind) || controller.kind == ControllerKind::spin_damping;
    is_scalar_.push_back(scalar);
    is_torque_.push_back(torque);
    ControlLoopInfo info{unique_name(words.name, loops_), "spacecraft", words.quantity,
                         fmt::format("controller.{}", i)};
    const std::string stem = fmt::format("controller_{}", i + 1), of = " of the controller " + info.name;
    const auto add_quantity = [&](const char* name, const char* meaning) {
      return scalar ? add(stem + "_" + name, words.unit, meaning + of)
                    : add_vector(stem + "_" + name, words.unit, meaning + of);
    };
    info.state = add(stem + "_state", "1", kStateMeaning + of);
    info.set_point = add_quantity("set_point", "set point");
    info.actual = add_quantity("actual", "controlled quantity");
    info.error = add_quantity("error", "error");
    const std::string effort = torque ? "torque" : "force";
    info.commanded = add_vector(stem + "_" + effort, torque ? "N m" : "N",
                                fmt::format("{} that is demanded by the controller {}, world axes", effort, info.name));
    info.delivered = by_axis("exerted_" + effort);
    if (torque ? actuators.limits_torque() : actuators.limits_force()) info.load = {effort + "_load"};
    if (controller.observer > 0 && loop_->has_observer()) info.disturbance = by_axis("disturbance_" + effort);
    loops_.push_back(std::move(info));
  }
}

void LoopChannels::add_winches(WinchDrive drive) {
  const DriveWords words = words_of(drive);
  const std::size_t count = winches_->winches().size();
  const auto name = [](const char* stem, std::size_t i) { return fmt::format("{}_{}", stem, i + 1); };
  for (std::size_t i = 0; i < count; ++i) {
    ControlLoopInfo info{fmt::format("Winch {}", i + 1), fmt::format("closing rope {}", i + 1), words.quantity,
                         "winch"};
    info.state = {name("winch_state", i)};
    info.set_point = {name("winch_set_point", i)};
    info.actual = {name(words.actual, i)};
    info.delivered = {name("winch_torque", i)};
    info.load = {name("winch_load", i)};
    loops_.push_back(std::move(info));
  }
  const auto add_by_rope = [&](const char* stem, const char* unit, const std::string& meaning) {
    for (std::size_t i = 0; i < count; ++i) add(name(stem, i), unit, meaning);
  };
  add_by_rope("winch_state", "1", std::string(kStateMeaning) + " of a winch");
  add_by_rope("winch_set_point", words.unit, fmt::format("{} that a winch is to keep", words.quantity));
  add_by_rope("winch_load", "1", "torque of a winch's motor by its limit; 1: saturated");
}

void LoopChannels::add_disturbances() {
  for (const char* body : {"spacecraft", "target"}) {
    for (const char* effort : {"force", "torque"}) {
      add_vector(fmt::format("disturbance_on_{}_{}", body, effort), effort == std::string("force") ? "N" : "N m",
                 fmt::format("{} of disturbances on the {}, mean over the output interval, world axes", effort, body),
                 ChannelKind::interval);
    }
  }
}

void LoopChannels::fill(Snapshot& snapshot) const {
  LoopWriter out(snapshot);
  const BodyState& craft = snapshot.bodies[static_cast<std::size_t>(spacecraft_)];
  const BodyState& target = snapshot.bodies[static_cast<std::size_t>(target_)];
  if (loop_ != nullptr && loop_->actuators().limits_force()) out.write(loop_->actuators().force_load());
  if (loop_ != nullptr && loop_->actuators().limits_torque()) out.write(loop_->actuators().torque_load());
  for (std::size_t i = 0; i < is_scalar_.size(); ++i) {
    const ClosedLoop::View view = loop_->view(i, craft, target, snapshot.time);
    out.write(view.state);
    for (const Eigen::Vector3d& value : {view.tracking.set_point, view.tracking.actual, view.tracking.error}) {
      if (is_scalar_[i]) {
        out.write(value.x());
      } else {
        out.write(value);
      }
    }
    out.write(is_torque_[i] ? view.demand.torque : view.demand.force);
  }
  if (winches_ != nullptr) {
    const std::size_t count = winches_->winches().size();
    for (std::size_t i = 0; i < count; ++i) out.write(winches_->state(i, snapshot.time));
    for (std::size_t i = 0; i < count; ++i) out.write(winches_->set_point(i, snapshot.time));
    for (std::size_t i = 0; i < count; ++i) out.write(winches_->load(i));
  }
  if (disturbances_ == nullptr) return;
  for (const DisturbedBody body : {DisturbedBody::spacecraft, DisturbedBody::target}) {
    const Wrench mean = disturbances_->take_mean(body, snapshot.time);
    out.write(mean.force);
    out.write(mean.torque);
  }
}

}  // namespace netpocket
