#include "gui/workbench/editor/scenario_difference.h"

#include <QCoreApplication>

#include "engine/scenario/parameter_text.h"
#include "gui/workbench/editor/parameter_words.h"

namespace netpocket {
namespace {

QString plain_words(const Parameter& parameter, const ParameterValue& value) {
  // Tables of equally many rows would look the same.
  if (parameter.type == ParameterType::pairs) return QString::fromStdString(toml_text(parameter, value));
  QString words = value_words(parameter, value);
  const QString unit = " " + unit_words(parameter.unit);
  if (!parameter.unit.empty() && words.endsWith(unit)) words.chop(unit.size());
  return words;
}

QString name_of(const Parameter& parameter, const Scenario& scenario) {
  const QString table = table_title(parameter, scenario.system);
  if (table.isEmpty()) return label(parameter);
  return QCoreApplication::translate("ScenarioDifference", "%1: %2").arg(table, label(parameter));
}

}  // namespace

std::vector<ScenarioDifference> differences(const Scenario& here, const Scenario& there) {
  if (here.system != there.system) {
    return {{nullptr,
             "system",
             QCoreApplication::translate("ScenarioDifference", "Capture system"),
             QString::fromStdString(here.system),
             QString::fromStdString(there.system),
             {}}};
  }
  std::vector<ScenarioDifference> rows;
  for (const Parameter* parameter : parameters_of(here)) {
    if (find_parameter(parameter->key, there) == nullptr) continue;
    const ParameterValue mine = parameter->get(here), other = parameter->get(there);
    if (mine == other) continue;
    rows.push_back({parameter, from_utf8(parameter->key), name_of(*parameter, here), plain_words(*parameter, mine),
                    plain_words(*parameter, other), unit_of(*parameter, here)});
  }
  for (const ParameterList& list : parameter_lists(here.system)) {
    if (list.size(here) == list.size(there)) continue;
    rows.push_back({nullptr,
                    from_utf8(list.name),
                    title(list),
                    QString::number(list.size(here)),
                    QString::number(list.size(there)),
                    {}});
  }
  return rows;
}

}  // namespace netpocket
