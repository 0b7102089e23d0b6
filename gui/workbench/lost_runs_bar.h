#pragma once
// Offers runs that a crashed session has left behind.

#include <deque>

#include "gui/workbench/editor/message_bar.h"
#include "gui/workbench/session/run_library.h"

namespace netpocket {

class LostRunsBar : public MessageBar {
  Q_OBJECT
 public:
  // Looks for them in `folder`. The library must outlive the bar.
  LostRunsBar(RunLibrary& runs, const QString& folder, QWidget* parent = nullptr);

  void recover();
  void discard();

 private:
  void offer();

  RunLibrary& runs_;
  std::deque<LostRuns> lost_;  // of one session each
};

}  // namespace netpocket
