#include "engine/scenario/check_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "engine/scenario/check_times.h"
#include "engine/scenario/parameters.h"

namespace netpocket {
namespace {

bool has_feed_forward(const ControllerParameters& controller) {
  return controller.feed_forward && (controller.kind == ControllerKind::attitude_sliding_mode ||
                                     controller.kind == ControllerKind::position_sliding_mode);
}

bool reads(const ControllerParameters& controller, SensorKind kind) {
  const bool attitude = is_of_attitude(controller.kind), position = is_of_position(controller.kind);
  const bool tow = controller.kind == ControllerKind::tow;
  const bool separation = tow && controller.quantity == TowQuantity::separation;
  const bool lever = has_feed_forward(controller) && attitude;
  switch (kind) {
    case SensorKind::attitude:
      return true;  // it turns demands into the axes of the actuators
    case SensorKind::angular_velocity:
      return attitude || controller.kind == ControllerKind::spin_damping;
    case SensorKind::position:
      return position || separation || lever;
    case SensorKind::velocity:
      return position || tow;
    case SensorKind::target_position:
      return separation || lever;
    case SensorKind::target_velocity:
      return separation;
    case SensorKind::contact_force:
      return has_feed_forward(controller) || (tow && controller.most_tension > 0);
    case SensorKind::rope_tension:
      return false;
  }
  return false;
}

// The name of a choice, from the parameter table.
std::string choice_name(std::string_view key, const Scenario& scenario) {
  const Parameter& parameter = *find_parameter(key, scenario);
  return std::string(parameter.choices[static_cast<std::size_t>(std::get<Choice>(parameter.get(scenario)).index)]);
}

class ControlChecker {
 public:
  ControlChecker(const Scenario& scenario, Diagnostics& problems) : s_(scenario), found_(problems) {}

  void run() {
    check_actuators();
    for (std::size_t i = 0; i < s_.controllers.size(); ++i) check_controller(i);
    check_tow();
    check_abort();
    for (std::size_t i = 0; i < s_.sensors.size(); ++i) check_sensor(i);
    check_winch();
    check_deflation();
    check_target();
    check_disturbances();
  }

 private:
  void add(std::string key, std::string message) { found_.add({.key = std::move(key), .message = std::move(message)}); }

  static std::string key_of(std::string_view list, std::size_t item, std::string_view name) {
    return fmt::format("{}.{}.{}", list, item, name);
  }

  void check_actuators() {
    for (std::size_t i = 0; i < s_.thrusters.size(); ++i) {
      if (s_.thrusters[i].direction == Eigen::Vector3d::Zero())
        add(key_of("actuators.thruster", i, "direction"), "a thruster needs a direction, not [0, 0, 0]");
    }
    for (std::size_t i = 0; i < s_.wheels.size(); ++i) {
      if (s_.wheels[i].axis == Eigen::Vector3d::Zero())
        add(key_of("actuators.wheel", i, "axis"), "a reaction wheel needs an axis, not [0, 0, 0]");
    }
    const bool fires = s_.actuators.kind == ActuatorKind::thrusters;
    if (fires && s_.thrusters.empty())
      add("actuators.kind", "there are no thrusters: list them as [[actuators.thruster]]");
    if (!fires && !s_.thrusters.empty()) {
      add("actuators.thruster", fmt::format("nothing fires the thrusters, since actuators.kind is \"{}\"",
                                            choice_name("actuators.kind", s_)));
    }
  }

  void check_controller(std::size_t i) {
    const ControllerParameters& controller = s_.controllers[i];
    const StationKeeping keeping = s_.spacecraft.station_keeping;
    const bool turns = is_of_attitude(controller.kind) || controller.kind == ControllerKind::spin_damping;
    const bool moves_across = is_of_position(controller.kind) && controller.axes != ControlledAxes::axial;
    if ((turns && keeping != StationKeeping::free) || (moves_across && keeping == StationKeeping::lateral)) {
      add(key_of("controller", i, "kind"),
          fmt::format("has no effect, since spacecraft.station_keeping = \"{}\" prescribes that motion",
                      choice_name("spacecraft.station_keeping", s_)));
    }
    if (const auto reason = why_phase_never_comes(controller.phase)) {
      add(key_of("controller", i, "phase"),
          fmt::format("the phase \"{}\" never comes: {}", choice_name(key_of("controller", i, "phase"), s_), *reason));
    }
  }

  std::optional<std::string> why_phase_never_comes(ControlPhase phase) const {
    const bool tows = s_.towing.mode != TowingMode::none;
    switch (phase) {
      case ControlPhase::open:
        if (s_.closing.starts_at == ClosingStart::time && s_.closing.start == 0) return "the closing starts at 0 s";
        break;
      case ControlPhase::closed:
        if (tows && s_.towing.starts_at == TowingStart::closed) return "the towing starts when the pocket is closed";
        if (tows && s_.closing.starts_at == ClosingStart::time && s_.towing.start <= closing_end(s_.closing))
          return fmt::format("the towing starts at {:g} s, before the closing ends at {:g} s", s_.towing.start,
                             closing_end(s_.closing));
        break;
      case ControlPhase::towing:
        if (!tows) return "towing.mode is \"none\"";
        break;
      case ControlPhase::always:
      case ControlPhase::closing:
      case ControlPhase::off:
        break;
    }
    return std::nullopt;
  }

  void check_tow() {
    const auto tows = [](const ControllerParameters& controller) { return controller.kind == ControllerKind::tow; };
    const bool has_tow = std::ranges::any_of(s_.controllers, tows);
    if (s_.towing.mode == TowingMode::controlled && !has_tow)
      add("towing.mode", "\"controlled\" needs a [[controller]] of the kind \"tow\"");
    for (std::size_t i = 0; i < s_.controllers.size(); ++i) {
      if (!tows(s_.controllers[i])) continue;
      const std::string key = key_of("controller", i, "kind");
      if (s_.towing.mode != TowingMode::controlled) add(key, "\"tow\" needs towing.mode = \"controlled\"");
      const ControlPhase phase = s_.controllers[i].phase;
      if (phase != ControlPhase::always && phase != ControlPhase::towing && phase != ControlPhase::off)
        add(key_of("controller", i, "phase"), "a controller of the kind \"tow\" acts in the phase \"towing\" only");
    }
  }

  void check_abort() {
    if (s_.towing.abort_force > 0 && s_.towing.mode == TowingMode::none)
      add("towing.abort_force", "there is no towing that it could end: towing.mode is \"none\"");
  }

  void check_sensor(std::size_t i) {
    const SensorKind kind = s_.sensors[i].kind;
    const std::string key = key_of("sensor", i, "kind");
    const auto first = std::ranges::find(s_.sensors, kind, &SensorParameters::kind) - s_.sensors.begin();
    if (first != static_cast<std::ptrdiff_t>(i))
      add(key, fmt::format("sensor.{} measures \"{}\" already", first, choice_name(key, s_)));
    if (!is_read(kind, s_))
      add(key, fmt::format("nothing reads a sensor of \"{}\": no controller or winch of this scenario uses it",
                           choice_name(key, s_)));
  }

  void check_winch() {
    const bool prescribed = s_.winch.drive == WinchDrive::prescribed;
    check_rope_times("winch.late", s_.winch.late, prescribed);
    check_rope_times("winch.jammed", s_.winch.jammed, prescribed);
  }

  void check_rope_times(const std::string& key, const std::vector<Eigen::Vector2d>& rows, bool prescribed) {
    if (prescribed && !rows.empty()) {
      add(key, "needs a winch.drive other than \"prescribed\", whose ropes follow closing.law exactly");
      return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double rope = rows[i].x();
      if (rope != std::trunc(rope) || rope < 1 || rope > s_.pocket.rod_count) {
        add(key, fmt::format("row {} names rope {}; the ropes are 1 to {}", i + 1, rope, s_.pocket.rod_count));
      } else if (std::ranges::count(rows, rope, [](const auto& row) { return row.x(); }) > 1) {
        add(key, fmt::format("names rope {} more than once", rope));
        return;
      }
    }
  }

  void check_deflation() {
    const DeflationParameters& deflation = s_.deflation;
    if (deflation.starts_at == DeflationStart::never || deflation.pressure < s_.rods.pressure) return;
    add("deflation.pressure",
        fmt::format("must be below rods.pressure = {:g} Pa, or there is nothing to let out", s_.rods.pressure));
  }

  void check_target() {
    const TargetParameters& target = s_.target;
    const bool acts = target.thrust != Eigen::Vector3d::Zero() || target.torque != Eigen::Vector3d::Zero();
    if (acts && target.acts_until <= target.acts_from) {
      add("target.acts_until",
          fmt::format("must be later than target.acts_from = {:g} s, or thrust and torque never act",
                      target.acts_from));
    }
  }

  void check_disturbances() {
    for (std::size_t i = 0; i < s_.disturbances.size(); ++i) {
      const DisturbanceParameters& disturbance = s_.disturbances[i];
      if (disturbance.force == Eigen::Vector3d::Zero() && disturbance.torque == Eigen::Vector3d::Zero())
        add(key_of("disturbance", i, "force"), "a disturbance needs a force or a torque");
    }
  }

  const Scenario& s_;
  Diagnostics& found_;
};

}  // namespace

bool is_of_attitude(ControllerKind kind) {
  return kind == ControllerKind::attitude_pd || kind == ControllerKind::attitude_sliding_mode ||
         kind == ControllerKind::attitude_double_loop;
}

bool is_of_position(ControllerKind kind) {
  return kind == ControllerKind::position_pd || kind == ControllerKind::position_sliding_mode;
}

bool is_read(SensorKind kind, const Scenario& scenario) {
  if (kind == SensorKind::rope_tension) return scenario.winch.drive == WinchDrive::tension;
  return std::ranges::any_of(scenario.controllers, [&](const auto& controller) { return reads(controller, kind); });
}

void check_control(const Scenario& scenario, Diagnostics& problems) { ControlChecker(scenario, problems).run(); }

}  // namespace netpocket
