#pragma once
// What the user interface calls parameters, their units and their values, from the parameter table.

#include <QString>
#include <optional>
#include <string_view>

#include "engine/scenario/parameters.h"

namespace netpocket {

QString from_utf8(std::string_view text);

// "Young's modulus" for net.youngs_modulus.
QString label(const Parameter& parameter);
// "Net cords: Young's modulus"
QString full_label(const Parameter& parameter);
QString title(const ParameterGroup& group);
QString title(const ParameterList& list);
// One sentence, or a part of one.
QString help(const ParameterGroup& group);
QString help(const Parameter& parameter);
// Of the table that a parameter belongs to; of an item of a list with its number: "Controllers 1".
QString table_title(const Parameter& parameter, std::string_view system = kPocketSystem);
// The list of a parameter that belongs to an item; else null.
const ParameterList* list_of(const Parameter& parameter, std::string_view system = kPocketSystem);

// A unit with typographic signs: "kg/m³" for "kg/m^3".
QString unit_words(std::string_view unit);
// Of a parameter as a whole: empty for lists of pairs, whose columns have units of their own, and for units by mode.
QString unit_of(const Parameter& parameter, const Scenario& scenario);

// The shortest text that reads back as the same number, as in TOML: "12e9".
QString number_words(double value);
// A value with unit for menus and tool tips; lists of pairs by their number of rows.
QString value_words(const Parameter& parameter, const ParameterValue& value);

// HTML: what it is, key, limits, source.
QString tool_tip(const Parameter& parameter);

// Why the parameter is not used with the others as they are; empty when it is.
std::optional<QString> why_unused(const Parameter& parameter, const Scenario& scenario);

// What changing a parameter means to a run that goes on.
enum class EditEffect { none, at_once, restart };

// Names have no effect; strategy acts at once (engine/scenario/strategy.h); everything else makes another model.
EditEffect edit_effect(const Parameter& parameter, std::string_view system = kPocketSystem);

}  // namespace netpocket
