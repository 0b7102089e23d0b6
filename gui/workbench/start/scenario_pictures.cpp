#include "gui/workbench/start/scenario_pictures.h"

#include <stdexcept>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "gui/workbench/editor/presets.h"
#include "gui/workbench/start/scenario_sketch.h"

namespace netpocket {
namespace {

QImage picture_of(const Preset& preset, const QSize& pixels, Background background) {
  const ScenarioResult result = read_scenario_text(preset.text.toStdString(), {});
  if (!result.ok() || !check_scenario(result.scenario).ok()) return {};
  try {
    return sketch_pocket(preview_pocket(result.scenario), pixels, background);
  } catch (const std::runtime_error&) {
    return {};
  }
}

}  // namespace

ScenarioPictures::~ScenarioPictures() = default;

void ScenarioPictures::draw(const QSize& pixels, Background background) {
  // The thread before is waited for; its pictures that have not come yet have the colours of then, and are followed by
  // the new ones.
  thread_ = std::jthread([this, pixels, background](const std::stop_token& stop) {
    for (int i = 0; const Preset& preset : presets()) {
      if (stop.stop_requested()) return;
      const QImage picture = picture_of(preset, pixels, background);
      const auto deliver = [this, index = i++, picture] { emit drawn(index, picture); };
      if (!picture.isNull()) QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    }
  });
}

}  // namespace netpocket
