#include "gui/workbench/preview_builder.h"

#include <stdexcept>
#include <utility>

#include "engine/scenario/check_scenario.h"

namespace netpocket {

PreviewBuilder::PreviewBuilder()
    : task_(std::make_unique<LatestTask<Request>>([this](const Request& request) { build_in_background(request); })) {}

PreviewBuilder::~PreviewBuilder() { task_.reset(); }

void PreviewBuilder::build(const Scenario& scenario) { task_->submit({++asked_, scenario}); }

void PreviewBuilder::build_in_background(const Request& request) {
  if (!check_scenario(request.scenario).ok()) return;
  try {
    Result result{request.number, preview_pocket(request.scenario)};
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
  } catch (const std::runtime_error&) {
    return;  // The mesh file went away since the check; the editor's next check says so.
  }
  QMetaObject::invokeMethod(this, &PreviewBuilder::take_result, Qt::QueuedConnection);
}

void PreviewBuilder::take_result() {
  std::optional<Result> result;
  {
    const std::lock_guard lock(mutex_);
    result = std::exchange(result_, std::nullopt);
  }
  if (result && result->number > forgotten_) emit built(result->preview);
}

}  // namespace netpocket
