#include "gui/workbench/editor/parameter_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

#include "engine/scenario/parameter_text.h"
#include "engine/scenario/strategy.h"
#include "engine/scenario/unused_parameters.h"
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

// What why_parameter_unused() says, for the translators.
[[maybe_unused]] constexpr const char* kReasons[] = {
    QT_TRANSLATE_NOOP("ParameterWords", "Used for spheres and cylinders."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used for boxes and satellites."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used for cylinders."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used for satellites."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used for meshes."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used when inertia is given, not the shape's."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used by the law “table”."),
    QT_TRANSLATE_NOOP("ParameterWords", "Not used by the law “table”."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used when the step is chosen, time step 0."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used with a perturbation."),
    QT_TRANSLATE_NOOP("ParameterWords", "Not used by this kind of controller."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used for the separation."),
    QT_TRANSLATE_NOOP("ParameterWords", "Not used by the drive “prescribed”."),
    QT_TRANSLATE_NOOP("ParameterWords", "Not used by this drive."),
    QT_TRANSLATE_NOOP("ParameterWords", "Not used by this start."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used with a tether."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used with a winch."),
    QT_TRANSLATE_NOOP("ParameterWords", "Not used with a winch."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used with a drawstring."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used with rings."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used when the mode is not “none”."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used when the model is not “off”."),
    QT_TRANSLATE_NOOP("ParameterWords", "Used with friction."),
};

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
  const std::string reason(why_parameter_unused(parameter, scenario));
  if (reason.empty()) return std::nullopt;
  return ParameterWords::tr(reason.c_str());
}

EditEffect edit_effect(const Parameter& parameter, std::string_view system) {
  if (parameter.key == "system") return EditEffect::restart;
  if (parameter.group().empty()) return EditEffect::none;
  return acts_at_once(parameter.key, system) ? EditEffect::at_once : EditEffect::restart;
}

}  // namespace netpocket
