#pragma once
// The plot of what was picked in a view: of all recorded frames of its run, and growing with it.
// Thread contract: the user interface's thread.

#include <QObject>
#include <optional>

#include "gui/workbench/picked_series.h"
#include "gui/workbench/session/capture_session.h"

namespace netpocket {

class PlotsPanel;

class PickedPlot : public QObject {
  Q_OBJECT
 public:
  PickedPlot(CaptureSession& session, PlotsPanel& plots, QObject* parent);

  // False when the run has no frames. What is picked in the shown run is plotted of whichever run is shown later, as
  // far as its pocket has the same parts.
  bool plot(RunId run, const Pick& pick);

 private:
  void show_run(RunId run);
  void collect();
  void take(const std::vector<double>& times, const std::vector<std::vector<double>>& rows);
  void catch_up();
  void show();

  CaptureSession& session_;
  PlotsPanel& plots_;
  RunId run_ = -1;
  bool follows_ = false;  // whichever run is shown
  bool collecting_ = false;
  bool bring_up_ = false;  // the plot, once there is something in it
  std::optional<Pick> pick_;
  std::shared_ptr<const Structure> structure_;  // of the pocket that it was picked in
  std::vector<PickedQuantity> quantities_;
  std::vector<double> times_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace netpocket
