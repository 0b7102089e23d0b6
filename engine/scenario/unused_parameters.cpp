#include "engine/scenario/unused_parameters.h"

#include <algorithm>
#include <initializer_list>
#include <variant>
#include <vector>

#include "engine/scenario/tether_drum.h"

namespace netpocket {
namespace {

std::string_view unused_unless(bool used, std::string_view reason) { return used ? std::string_view() : reason; }

std::string_view why_target_unused(std::string_view name, const TargetParameters& target) {
  using enum TargetShape;
  const auto unused_but_for = [&](std::initializer_list<TargetShape> users, std::string_view reason) {
    return unused_unless(std::find(users.begin(), users.end(), target.shape) != users.end(), reason);
  };
  if (name == "radius") return unused_but_for({sphere, cylinder}, "Used for spheres and cylinders.");
  if (name == "size") return unused_but_for({box, satellite}, "Used for boxes and satellites.");
  if (name == "length") return unused_but_for({cylinder}, "Used for cylinders.");
  if (name == "span" || name == "panel_width" || name == "dish_diameter")
    return unused_but_for({satellite}, "Used for satellites.");
  if (name == "mesh_file" || name == "mesh_unit") return unused_but_for({mesh}, "Used for meshes.");
  if (name == "inertia")
    return unused_unless(target.inertia_from == InertiaSource::given, "Used when inertia is given, not the shape's.");
  return {};
}

std::string_view why_closing_unused(std::string_view name, const ClosingParameters& closing) {
  const bool table = closing.law == ClosingLaw::table;
  if (name == "table") return unused_unless(table, "Used by the law “table”.");
  if (name == "duration" || name == "closed_length") return unused_unless(!table, "Not used by the law “table”.");
  return {};
}

std::string_view why_solver_unused(std::string_view name, const SolverParameters& solver) {
  if (name == "safety") return unused_unless(solver.time_step == 0, "Used when the step is chosen, time step 0.");
  if (name == "seed") return unused_unless(solver.perturbation > 0, "Used with a perturbation.");
  return {};
}

// Kinds of controllers by what they use beyond rate and phase.
std::string_view why_controller_unused(std::string_view name, const ControllerParameters& controller) {
  using enum ControllerKind;
  const auto used_by = [&](std::initializer_list<std::string_view> names, std::initializer_list<ControllerKind> kinds) {
    return std::ranges::find(names, name) == names.end() || std::ranges::find(kinds, controller.kind) != kinds.end();
  };
  const bool used =
      used_by({"attitude"}, {attitude_pd, attitude_sliding_mode, attitude_double_loop}) &&
      used_by({"position", "velocity", "axes"}, {position_pd, position_sliding_mode}) &&
      used_by({"frequency", "damping_ratio"}, {attitude_pd, position_pd}) &&
      used_by({"slope", "reaching", "switching", "layer", "observer"},
              {attitude_sliding_mode, attitude_double_loop, position_sliding_mode}) &&
      used_by({"feed_forward"}, {attitude_sliding_mode, position_sliding_mode}) &&
      used_by({"outer_switching", "outer_layer", "fastest"}, {attitude_double_loop}) &&
      used_by({"quantity", "wanted", "ramp", "proportional", "integral", "derivative", "most_tension"}, {tow}) &&
      used_by({"damping", "most_torque"}, {spin_damping});
  if (!used) return "Not used by this kind of controller.";
  const bool speed = controller.quantity == TowQuantity::speed;
  return unused_unless(name != "derivative" || !speed, "Used for the separation.");
}

std::string_view why_winch_unused(std::string_view name, WinchDrive drive) {
  using enum WinchDrive;
  if (name == "drive") return {};
  if (drive == prescribed) return "Not used by the drive “prescribed”.";
  const auto used_by = [&](std::initializer_list<std::string_view> names, std::initializer_list<WinchDrive> drives) {
    return std::ranges::find(names, name) == names.end() || std::ranges::find(drives, drive) != drives.end();
  };
  const bool used = used_by({"rate"}, {rate}) && used_by({"torque"}, {torque}) && used_by({"length_gain"}, {length}) &&
                    used_by({"tension", "tension_gain", "tension_derivative", "take_up_rate"}, {tension}) &&
                    used_by({"fastest", "rate_gain", "rate_integral"}, {length, rate, tension});
  return unused_unless(used, "Not used by this drive.");
}

// Of a system that has this parameter.
bool is_switched_on(const Scenario& scenario, std::string_view key) {
  return std::get<bool>(find_parameter(key, scenario)->get(scenario));
}

std::string_view chosen(const Scenario& scenario, std::string_view key) {
  const Parameter& parameter = *find_parameter(key, scenario);
  return parameter.choices[static_cast<std::size_t>(std::get<Choice>(parameter.get(scenario)).index)];
}

bool is_of_drum(std::string_view key) {
  static const std::vector<Parameter> kDrum = tether_drum_parameters();
  return std::ranges::find(kDrum, key, &Parameter::key) != kDrum.end();
}

std::string_view why_drum_unused(std::string_view name, const Scenario& scenario) {
  const std::string_view drive = chosen(scenario, "tether.drive");
  const bool has_motor = drive == "rate" || drive == "tension";
  const bool brakes_at_time = chosen(scenario, "tether.brake_starts_at") == "time";
  const bool used =
      (name != "rate" || drive == "rate") && (name != "tension" || drive == "tension" || drive == "drag") &&
      (has_motor || (name != "motor_torque" && name != "fastest")) && (drive != "brake" || !name.starts_with("drive_"));
  if (!used) return "Not used by this drive.";
  const bool is_waited_for = (name != "brake_at" || brakes_at_time) && (name != "brake_delay" || !brakes_at_time);
  return unused_unless(is_waited_for, "Not used by this start.");
}

// Of a pocket or a thrown net.
std::string_view why_tether_unused(const Parameter& parameter, const Scenario& scenario) {
  const std::string_view name = parameter.name();
  if (name == "attached") return {};
  if (!is_switched_on(scenario, "tether.attached")) return "Used with a tether.";
  if (name == "winch") return {};
  const bool is_wound = is_switched_on(scenario, "tether.winch");
  if (is_of_drum(parameter.key)) {
    return is_wound ? why_drum_unused(name, scenario) : "Used with a winch.";
  }
  if (name == "elements" || name == "bending_damping") return unused_unless(!is_wound, "Not used with a winch.");
  if (!name.starts_with("release_")) return {};
  const bool at_time = chosen(scenario, "tether.released_at") == "time";
  return unused_unless(at_time == (name == "release_time"), "Not used by this start.");
}

std::string_view why_drawstring_unused(std::string_view name, const Scenario& scenario) {
  const std::string_view start = chosen(scenario, "drawstring.starts_at");
  if (name == "starts_at") return {};
  if (start == "never") return "Used with a drawstring.";
  if ((name == "start" && start != "time") || (name == "delay" && start != "contact")) return "Not used by this start.";
  return unused_unless(!name.starts_with("ring_") || chosen(scenario, "drawstring.passage") == "rings",
                       "Used with rings.");
}

}  // namespace

std::string_view why_parameter_unused(const Parameter& parameter, const Scenario& scenario) {
  std::string_view reason;
  if (parameter.group() == "target") reason = why_target_unused(parameter.name(), scenario.target);
  if (parameter.group() == "closing") reason = why_closing_unused(parameter.name(), scenario.closing);
  if (parameter.group() == "solver") reason = why_solver_unused(parameter.name(), scenario.solver);
  if (parameter.group() == "winch") reason = why_winch_unused(parameter.name(), scenario.winch.drive);
  const bool has_drum = find_parameter("tether.winch", scenario) != nullptr;
  if (has_drum && parameter.group() == "tether") reason = why_tether_unused(parameter, scenario);
  if (has_drum && parameter.group() == "drawstring") reason = why_drawstring_unused(parameter.name(), scenario);
  if (parameter.group() == "controller" && parameter.item < scenario.controllers.size()) {
    reason = why_controller_unused(parameter.name(), scenario.controllers[parameter.item]);
  }
  if (parameter.group() == "towing" && parameter.name() != "mode" && scenario.towing.mode == TowingMode::none) {
    reason = "Used when the mode is not “none”.";
  }
  if (parameter.group() == "orbit" && parameter.name() != "model" && !scenario.orbit.is_on()) {
    reason = "Used when the model is not “off”.";
  }
  if (parameter.key == "contact.friction_velocity" && scenario.contact.friction == 0) reason = "Used with friction.";
  return reason;
}

}  // namespace netpocket
