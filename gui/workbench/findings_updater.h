#pragma once
// Evaluates the findings of the compared runs in the background, now and then while a run grows.
// Thread contract: the user interface's thread.

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/analysis/summary.h"
#include "gui/workbench/session/capture_session.h"
#include "gui/workbench/simulation/latest_task.h"

namespace netpocket {

struct FindingsResult {
  std::vector<Finding> findings;
  Verdict captured = Verdict::unknown;
  std::string why_not;  // one sentence, when the shown run does not count as a capture
  bool running = false;
  std::string failure;  // why nothing could be evaluated
};

class FindingsUpdater : public QObject {
  Q_OBJECT
 public:
  // `runs` gives the runs to judge, the shown one first.
  FindingsUpdater(CaptureSession& session, std::function<std::vector<RunId>()> runs);
  ~FindingsUpdater() override;

  // Soon, and not more often than every second or so.
  void request();

 signals:
  void evaluated(const netpocket::FindingsResult& result);

 private:
  struct Job {
    std::vector<std::string> paths;
    bool running = false;
  };

  void begin();

  CaptureSession& session_;
  std::function<std::vector<RunId>()> runs_;
  QTimer timer_;
  std::unique_ptr<LatestTask<Job>> task_;
};

}  // namespace netpocket
