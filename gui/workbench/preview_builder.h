#pragma once
// Follows the edits of a scenario with pictures of the pocket, built in the background.
// Thread contract: the user interface's thread.

#include <QObject>
#include <memory>

#include "gui/workbench/simulation/latest_task.h"
#include "gui/workbench/simulation/pocket_preview.h"

namespace netpocket {

class PreviewBuilder : public QObject {
  Q_OBJECT
 public:
  PreviewBuilder();
  ~PreviewBuilder() override;

  // Of several scenarios in a row the last one counts. One with an error keeps the preview before it.
  void build(const Scenario& scenario) { task_->submit(scenario); }

 signals:
  void built(const netpocket::PocketPreview& preview);

 private:
  std::unique_ptr<LatestTask<Scenario>> task_;
};

}  // namespace netpocket
