#include "gui/workbench/preview_builder.h"

#include "engine/scenario/check_scenario.h"

namespace netpocket {

PreviewBuilder::PreviewBuilder() {
  task_ = std::make_unique<LatestTask<Scenario>>([this](const Scenario& scenario) {
    if (!check_scenario(scenario).ok()) return;
    QMetaObject::invokeMethod(
        this, [this, preview = preview_pocket(scenario)] { emit built(preview); }, Qt::QueuedConnection);
  });
}

PreviewBuilder::~PreviewBuilder() { task_.reset(); }

}  // namespace netpocket
