#pragma once
// One run of the session as the window knows it: simulated here, a branch of another, or opened from a file.
// Thread contract: the user interface's thread; `file` is used on the storage thread only.

#include <QString>
#include <algorithm>
#include <memory>
#include <vector>

#include "gui/workbench/session/run_file.h"
#include "gui/workbench/simulation/worker_messages.h"
#include "render/figures/run_series.h"

namespace netpocket {

enum class RunState { preparing, running, paused, ended, recorded };

// A moment worth going to.
struct TimeMark {
  enum class Kind { first_contact, peak_force, phase_end, phase_start, branch, strategy, disturbance, own };
  Kind kind;
  double time;  // s
  QString label;
};

struct Run {
  RunId id = -1;
  QString name;
  RunId parent = -1;       // of a branch
  double branch_time = 0;  // s
  Scenario scenario;       // with the strategy in force now
  std::shared_ptr<const Structure> structure;
  RunSeries series;  // channels of all frames
  std::shared_ptr<const Snapshot> first_frame;
  std::shared_ptr<RunFile> file;
  RunState state = RunState::preparing;
  RunStatus status;
  RunStatistics statistics;
  double speed = 0;  // simulated seconds for one of wall time, lately
  bool simulated_here = true;
  bool continuable = true;  // as a branch: what was recorded by another version is not
  bool temporary = true;    // its recording goes with the session
  std::size_t saved_frames = 0;
  std::vector<TimeMark> notes;  // own marks, strategy changes and the branch point

  std::size_t frame_count() const { return series.times().size(); }
  double end_time() const { return series.times().empty() ? 0 : series.times().back(); }
  // Whether there is something left to simulate.
  bool can_go_on() const;
  // Whether frames would be lost with the session.
  bool is_unsaved() const { return temporary && frame_count() > std::max<std::size_t>(saved_frames, 1); }
  // The frame nearest to a time (s); 0 when there is none.
  std::size_t frame_at(double time) const;
};

// What the channels say about the moments worth going to, and the run's own notes, by time.
std::vector<TimeMark> time_marks(const Run& run);

}  // namespace netpocket
