#pragma once
// What the channels of a recorded run say about phases, forces and motion. Times in s, forces in N, lengths in m.
// A recorded force is the mean over the output interval that ends at its frame.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/analysis/verdict.h"
#include "engine/recording/recording.h"

namespace netpocket {

enum class Body { target, spacecraft };

// Frames [first, last).
struct FrameRange {
  std::size_t first = 0;
  std::size_t last = 0;
  bool empty() const { return first >= last; }
};

struct Peak {
  double value = 0;  // with its sign
  double time = 0;
};

// Consecutive contact forces of one sign.
struct ContactEpisode {
  double impulse = 0;  // N s
  double start = 0;
  FrameRange frames{};  // whose intervals make it up
};

// `reason` says why the verdict is not yes; empty when it is.
struct Capture {
  Verdict verdict = Verdict::unknown;
  std::string reason;
};

class RunHistory {
 public:
  // The recording must outlive the history.
  explicit RunHistory(const Recording& recording) : RunHistory(recording, recording.origin().scenario_name) {}
  RunHistory(const Recording& recording, std::string name) : recording_(&recording), name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  double closing_end() const { return recording_->origin().closing_end; }
  double towing_start() const { return recording_->origin().towing_start; }
  double end() const { return times().empty() ? 0 : times().back(); }
  const std::vector<double>& times() const { return recording_->times(); }
  const std::vector<double>& channel(Channel c) const { return recording_->channel(c); }

  // Frames with from < t <= to.
  FrameRange frames(double from, double to) const;
  // Frames with from <= t.
  FrameRange frames_from(double from) const;
  FrameRange all() const { return {0, times().size()}; }
  FrameRange until_closed() const { return frames(-1e300, closing_end()); }
  FrameRange after_closed() const { return frames(closing_end(), 1e300); }
  FrameRange towing() const { return frames(towing_start(), 1e300); }

  // Median time between frames: the window over which recorded forces are means.
  double averaging_window() const;
  Eigen::Vector3d force(std::size_t frame) const;
  Peak peak(Channel c, FrameRange range) const;
  // Largest of |F_x| and |F_z|.
  double lateral_peak(FrameRange range) const;
  // Largest |F|.
  Peak force_peak() const;
  Eigen::Vector3d impulse() const;
  bool in_contact(std::size_t frame) const;
  std::optional<double> first_contact() const;

  // Episodes of F_y. Those whose impulse is below `smallest` of the largest are merged into the two between which they
  // lie, which become one; before the first and after the last they are left out.
  std::vector<ContactEpisode> episodes(FrameRange range, double smallest) const;

  Eigen::Vector3d position(Body body, std::size_t frame) const;
  // Largest |position - position at `origin`|, by component.
  Eigen::Vector3d excursion(Body body, FrameRange range, std::size_t origin) const;

  // Whether the run counts as a capture.
  Capture capture() const;
  // "diverged at t = 3.2 s", or empty.
  std::string divergence() const;

  const Recording& recording() const { return *recording_; }
  // s, from the frame before; the recorded force is the mean over it.
  double interval(std::size_t frame) const;

 private:
  const Recording* recording_;
  std::string name_;
};

// The rule of capture(), in words.
extern const char* const kCaptureRule;

}  // namespace netpocket
