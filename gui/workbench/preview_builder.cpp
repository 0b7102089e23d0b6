#include "gui/workbench/preview_builder.h"

#include <stdexcept>

#include "engine/scenario/check_scenario.h"

namespace netpocket {

PreviewBuilder::PreviewBuilder() {
  task_ = std::make_unique<LatestTask<Scenario>>([this](const Scenario& scenario) {
    if (!check_scenario(scenario).ok()) return;
    try {
      QMetaObject::invokeMethod(
          this, [this, preview = preview_pocket(scenario)] { emit built(preview); }, Qt::QueuedConnection);
    } catch (const std::runtime_error&) {
      // The mesh file went away since the check; the editor's next check says so.
    }
  });
}

PreviewBuilder::~PreviewBuilder() { task_.reset(); }

}  // namespace netpocket
