#include "gui/workbench/editor/parameter_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/strategy.h"
#include "engine/scenario/tether_drum.h"
#include "gui/workbench/panels/engine_words.h"

namespace netpocket {
namespace {

// `table`: where the words may mean something else than elsewhere, as "Rate" does.
QString translated(const QString& words, std::string_view table = {}) {
  return QCoreApplication::translate("parameters", words.toUtf8().constData(), std::string(table).c_str());
}

struct ParameterWords {
  Q_DECLARE_TR_FUNCTIONS(ParameterWords)
};

QString list_words(const Eigen::Vector3d& v) {
  return QString("(%1, %2, %3)").arg(number_words(v.x()), number_words(v.y()), number_words(v.z()));
}

QString unused_unless(bool used, const QString& reason) { return used ? QString() : reason; }

QString why_target_unused(std::string_view name, const TargetParameters& target) {
  using enum TargetShape;
  const auto unused_but_for = [&](std::initializer_list<TargetShape> users, const QString& reason) {
    return unused_unless(std::find(users.begin(), users.end(), target.shape) != users.end(), reason);
  };
  if (name == "radius")
    return unused_but_for({sphere, cylinder}, ParameterWords::tr("Used for spheres and cylinders."));
  if (name == "size") return unused_but_for({box, satellite}, ParameterWords::tr("Used for boxes and satellites."));
  if (name == "length") return unused_but_for({cylinder}, ParameterWords::tr("Used for cylinders."));
  if (name == "span" || name == "panel_width" || name == "dish_diameter")
    return unused_but_for({satellite}, ParameterWords::tr("Used for satellites."));
  if (name == "mesh_file" || name == "mesh_unit") return unused_but_for({mesh}, ParameterWords::tr("Used for meshes."));
  if (name == "inertia")
    return unused_unless(target.inertia_from == InertiaSource::given,
                         ParameterWords::tr("Used when inertia is given, not the shape's."));
  return {};
}

QString why_closing_unused(std::string_view name, const ClosingParameters& closing) {
  const bool table = closing.law == ClosingLaw::table;
  if (name == "table") return unused_unless(table, ParameterWords::tr("Used by the law “table”."));
  if (name == "duration" || name == "closed_length")
    return unused_unless(!table, ParameterWords::tr("Not used by the law “table”."));
  return {};
}

QString why_solver_unused(std::string_view name, const SolverParameters& solver) {
  if (name == "safety")
    return unused_unless(solver.time_step == 0, ParameterWords::tr("Used when the step is chosen, time step 0."));
  if (name == "seed") return unused_unless(solver.perturbation > 0, ParameterWords::tr("Used with a perturbation."));
  return {};
}

// Kinds of controllers by what they use beyond rate and phase.
QString why_controller_unused(std::string_view name, const ControllerParameters& controller) {
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
  if (!used) return ParameterWords::tr("Not used by this kind of controller.");
  const bool speed = controller.quantity == TowQuantity::speed;
  return unused_unless(name != "derivative" || !speed, ParameterWords::tr("Used for the separation."));
}

QString why_winch_unused(std::string_view name, WinchDrive drive) {
  using enum WinchDrive;
  if (name == "drive") return {};
  if (drive == prescribed) return ParameterWords::tr("Not used by the drive “prescribed”.");
  const auto used_by = [&](std::initializer_list<std::string_view> names, std::initializer_list<WinchDrive> drives) {
    return std::ranges::find(names, name) == names.end() || std::ranges::find(drives, drive) != drives.end();
  };
  const bool used = used_by({"rate"}, {rate}) && used_by({"torque"}, {torque}) && used_by({"length_gain"}, {length}) &&
                    used_by({"tension", "tension_gain", "tension_derivative", "take_up_rate"}, {tension}) &&
                    used_by({"fastest", "rate_gain", "rate_integral"}, {length, rate, tension});
  return unused_unless(used, ParameterWords::tr("Not used by this drive."));
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

QString why_drum_unused(std::string_view name, const Scenario& scenario) {
  const std::string_view drive = chosen(scenario, "tether.drive");
  const bool has_motor = drive == "rate" || drive == "tension";
  const bool brakes_at_time = chosen(scenario, "tether.brake_starts_at") == "time";
  const bool used =
      (name != "rate" || drive == "rate") && (name != "tension" || drive == "tension" || drive == "drag") &&
      (has_motor || (name != "motor_torque" && name != "fastest")) && (drive != "brake" || !name.starts_with("drive_"));
  if (!used) return ParameterWords::tr("Not used by this drive.");
  const bool is_waited_for = (name != "brake_at" || brakes_at_time) && (name != "brake_delay" || !brakes_at_time);
  return unused_unless(is_waited_for, ParameterWords::tr("Not used by this start."));
}

// Of a pocket or a thrown net.
QString why_tether_unused(const Parameter& parameter, const Scenario& scenario) {
  const std::string_view name = parameter.name();
  if (name == "attached") return {};
  if (!is_switched_on(scenario, "tether.attached")) return ParameterWords::tr("Used with a tether.");
  if (name == "winch") return {};
  const bool is_wound = is_switched_on(scenario, "tether.winch");
  if (is_of_drum(parameter.key)) {
    return is_wound ? why_drum_unused(name, scenario) : ParameterWords::tr("Used with a winch.");
  }
  if (name == "elements" || name == "bending_damping")
    return unused_unless(!is_wound, ParameterWords::tr("Not used with a winch."));
  if (!name.starts_with("release_")) return {};
  const bool at_time = chosen(scenario, "tether.released_at") == "time";
  return unused_unless(at_time == (name == "release_time"), ParameterWords::tr("Not used by this start."));
}

QString why_drawstring_unused(std::string_view name, const Scenario& scenario) {
  const std::string_view start = chosen(scenario, "drawstring.starts_at");
  if (name == "starts_at") return {};
  if (start == "never") return ParameterWords::tr("Used with a drawstring.");
  if ((name == "start" && start != "time") || (name == "delay" && start != "contact"))
    return ParameterWords::tr("Not used by this start.");
  return unused_unless(!name.starts_with("ring_") || chosen(scenario, "drawstring.passage") == "rings",
                       ParameterWords::tr("Used with rings."));
}

// The unit that a controller's kind chooses from "rad/s, m/s" or from "m/s or m by quantity".
std::string_view controller_unit(std::string_view unit, const ControllerParameters& controller) {
  const bool first = controller.kind == ControllerKind::tow ? controller.quantity == TowQuantity::speed
                                                            : controller.kind != ControllerKind::position_sliding_mode;
  if (const auto words = unit.find(" by "); words != unit.npos) unit = unit.substr(0, words);
  for (const std::string_view separator : {", ", " or "}) {
    const auto place = unit.find(separator);
    if (place != unit.npos) return first ? unit.substr(0, place) : unit.substr(place + separator.size());
  }
  return unit;
}

}  // namespace

QString from_utf8(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())); }

QString label(const Parameter& parameter) {
  QString words = from_utf8(parameter.name()).replace('_', ' ');
  words.replace("youngs", "Young's").replace("poisson ratio", "Poisson's ratio");
  words[0] = words[0].toUpper();
  return translated(words, parameter.group());
}

QString title(const ParameterGroup& group) { return translated(from_utf8(group.title)); }
QString title(const ParameterList& list) { return translated(from_utf8(list.title)); }
QString help(const ParameterGroup& group) { return translated(from_utf8(group.help)); }
QString help(const Parameter& parameter) { return translated(from_utf8(parameter.help)); }

QString full_label(const Parameter& parameter) {
  return ParameterWords::tr("%1: %2").arg(table_title(parameter), label(parameter).toLower());
}

const ParameterList* list_of(const Parameter& parameter, std::string_view system) {
  for (const ParameterList& list : parameter_lists(system)) {
    const std::string_view key = parameter.key;
    const bool begins = key.size() > list.name.size() + 1 && key.starts_with(list.name) && key[list.name.size()] == '.';
    const auto digit = static_cast<unsigned char>(begins ? key[list.name.size() + 1] : ' ');
    if (begins && std::isdigit(digit) != 0) return &list;
  }
  return nullptr;
}

QString table_title(const Parameter& parameter, std::string_view system) {
  const ParameterList* list = list_of(parameter, system);
  if (list != nullptr) return title(*list) + " " + QString::number(parameter.item + 1);
  const ParameterGroup* group = find_parameter_group(parameter.group(), system);
  return group != nullptr ? title(*group) : QString();
}

QString unit_words(std::string_view unit) {
  QString words = from_utf8(unit);
  words.replace("^2", "²").replace("^3", "³").replace(" ", QStringLiteral("\u202f"));
  return words;
}

QString unit_of(const Parameter& parameter, const Scenario& scenario) {
  if (parameter.type == ParameterType::pairs) return {};
  if (parameter.key.starts_with("controller.") && parameter.item < scenario.controllers.size()) {
    return unit_words(controller_unit(parameter.unit, scenario.controllers[parameter.item]));
  }
  if (parameter.key != "towing.size") return unit_words(parameter.unit);
  switch (scenario.towing.mode) {
    case TowingMode::force:
      return "N";
    case TowingMode::acceleration:
      return "m/s²";
    case TowingMode::velocity:
      return "m/s";
    case TowingMode::none:
    case TowingMode::controlled:
      break;
  }
  return {};
}

QString number_words(double value) {
  return QString::fromStdString(toml_text(parameters().front(), value));  // numbers look the same for every parameter
}

QString value_words(const Parameter& parameter, const ParameterValue& value) {
  QString words;
  if (const auto* number = std::get_if<double>(&value)) {
    words = number_words(*number);
  } else if (const auto* vector = std::get_if<Eigen::Vector3d>(&value)) {
    words = list_words(*vector);
  } else if (const auto* pairs = std::get_if<std::vector<Eigen::Vector2d>>(&value)) {
    return ParameterWords::tr("%n points", nullptr, static_cast<int>(pairs->size()));
  } else if (const auto* string = std::get_if<std::string>(&value)) {
    words = "“" + QString::fromStdString(*string).left(30) + "”";
  } else if (const auto* choice = std::get_if<Choice>(&value)) {
    words = from_utf8(parameter.choices[choice->index]);
  } else {
    words = QString::fromStdString(toml_text(parameter, value));
  }
  const bool single_unit = !parameter.unit.empty() && parameter.key != "towing.size";
  return single_unit ? words + " " + unit_words(parameter.unit) : words;
}

QString tool_tip(const Parameter& parameter) {
  const QString allowed = engine_words(allowed_text(parameter)).toHtmlEscaped();
  QString words = help(parameter).toHtmlEscaped();
  words[0] = words[0].toUpper();
  QStringList facts;
  if (!allowed.isEmpty()) facts << ParameterWords::tr("Allowed: %1").arg(allowed);
  if (!parameter.unit.empty()) facts << ParameterWords::tr("Unit: %1").arg(unit_words(parameter.unit));
  facts << ParameterWords::tr("Source: %1").arg(translated(from_utf8(parameter.source)).toHtmlEscaped());
  facts << ParameterWords::tr("Key: %1").arg("<code>" + from_utf8(parameter.key) + "</code>");
  return "<p>" + words + "</p><p>" + facts.join("<br>") + "</p>";
}

std::optional<QString> why_unused(const Parameter& parameter, const Scenario& scenario) {
  QString reason;
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
    reason = ParameterWords::tr("Used when the mode is not “none”.");
  }
  if (parameter.group() == "orbit" && parameter.name() != "model" && !scenario.orbit.is_on()) {
    reason = ParameterWords::tr("Used when the model is not “off”.");
  }
  if (parameter.key == "contact.friction_velocity" && scenario.contact.friction == 0)
    reason = ParameterWords::tr("Used with friction.");
  if (reason.isEmpty()) return std::nullopt;
  return reason;
}

EditEffect edit_effect(const Parameter& parameter, std::string_view system) {
  if (parameter.key == "system") return EditEffect::restart;
  if (parameter.group().empty()) return EditEffect::none;
  return acts_at_once(parameter.key, system) ? EditEffect::at_once : EditEffect::restart;
}

}  // namespace netpocket
