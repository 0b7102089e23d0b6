#include "gui/workbench/editor/presets.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include "engine/scenario/read_scenario.h"

namespace netpocket {
namespace {

std::vector<Preset> read_presets() {
  std::vector<Preset> found;
  const QDir folder(":/presets");
  for (const QString& file_name : folder.entryList({"*.toml"}, QDir::Files, QDir::Name)) {
    QFile file(folder.filePath(file_name));
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QByteArray bytes = file.readAll();
    const ScenarioResult result = read_scenario_text(bytes.toStdString(), file_name.toStdString());
    found.push_back({QString::fromStdString(result.scenario.name), QString::fromStdString(result.scenario.description),
                     QString::fromUtf8(bytes)});
  }
  return found;
}

}  // namespace

QString sentence_of(const Preset& preset) {
  return QCoreApplication::translate("scenarios", preset.description.toUtf8().constData());
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = read_presets();
  return all;
}

}  // namespace netpocket
