#pragma once
// Follows the edits of a scenario with pictures of the pocket, built in the background.
// Thread contract: the user interface's thread.

#include <QObject>
#include <memory>
#include <mutex>
#include <optional>

#include "gui/workbench/simulation/latest_task.h"
#include "gui/workbench/simulation/pocket_preview.h"

namespace netpocket {

class PreviewBuilder : public QObject {
  Q_OBJECT
 public:
  PreviewBuilder();
  ~PreviewBuilder() override;

  // Of several scenarios in a row the last one counts. One with an error keeps the preview before it.
  void build(const Scenario& scenario);
  // Something else is to be seen: what has been asked for until now is no longer wanted.
  void forget() { forgotten_ = asked_; }

 signals:
  void built(const netpocket::PocketPreview& preview);

 private:
  struct Request {
    std::int64_t number;
    Scenario scenario;
  };
  struct Result {
    std::int64_t number;
    PocketPreview preview;
  };
  void build_in_background(const Request& request);
  void take_result();

  std::int64_t asked_ = 0;        // number of the last request
  std::int64_t forgotten_ = 0;    // of the last one that is no longer wanted
  std::mutex mutex_;              // guards what follows
  std::optional<Result> result_;  // not yet taken
  std::unique_ptr<LatestTask<Request>> task_;
};

}  // namespace netpocket
