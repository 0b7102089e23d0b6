#include "gui/workbench/preview_builder.h"

#include <stdexcept>

#include "engine/scenario/check_scenario.h"

namespace netpocket {

PreviewBuilder::PreviewBuilder()
    : task_(std::make_unique<LatestTask<Request>>([this](const Request& request) { build_in_background(request); })) {}

PreviewBuilder::~PreviewBuilder() { task_.reset(); }

void PreviewBuilder::build(const Scenario& scenario) { task_->submit({++asked_, scenario}); }

void PreviewBuilder::build_in_background(const Request& request) {
  if (!check_scenario(request.scenario).ok()) return;
  try {
    const auto report = [this, number = request.number, preview = preview_pocket(request.scenario)] {
      if (number > forgotten_) emit built(preview);
    };
    QMetaObject::invokeMethod(this, report, Qt::QueuedConnection);
  } catch (const std::runtime_error&) {
    // The mesh file went away since the check; the editor's next check says so.
  }
}

}  // namespace netpocket
