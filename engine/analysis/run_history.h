#pragma once
// Phases, forces and motion of a run, from its channels. Times in s, forces in N, lengths in m.
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

// Successive contact forces F_y of one sign.
struct ContactEpisode {
  double impulse = 0;   // N s
  double start = 0;     // time of the first frame
  FrameRange frames{};  // the output intervals that end at these frames
};

// `reason` says why the verdict is not yes. It is empty when it is.
struct Capture {
  Verdict verdict = Verdict::unknown;
  std::string reason;
};

class RunHistory {
 public:
  // The data must outlive the history.
  explicit RunHistory(const RunData& data) : data_(&data), name_(data.origin().scenario_name) {}
  RunHistory(const Recording& recording, std::string name)
      : data_(&recording), recording_(&recording), name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  double closing_end() const { return phase_end(data_->origin().phases, kClosing); }
  double towing_start() const { return phase_begin(data_->origin().phases, kTowing); }
  double end() const { return times().empty() ? 0 : times().back(); }
  const std::vector<double>& times() const { return data_->times(); }
  const std::vector<double>& channel(Channel c) const { return data_->channel(c); }

  // Frames with from < t <= to.
  FrameRange frames(double from, double to) const;
  // Frames with from <= t.
  FrameRange frames_from(double from) const;
  FrameRange all() const { return {0, times().size()}; }
  FrameRange until_closed() const { return frames(-1e300, closing_end()); }
  FrameRange after_closed() const { return frames(closing_end(), 1e300); }
  FrameRange towing() const { return frames(towing_start(), 1e300); }

  // Median time between frames. Recorded forces are means over it.
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

  // Episodes of F_y. An episode whose impulse is below `smallest` (fraction) of the largest one is merged with its two
  // neighbours into one. If it is the first or the last, it is left out.
  std::vector<ContactEpisode> episodes(FrameRange range, double smallest) const;

  Eigen::Vector3d position(Body body, std::size_t frame) const;
  // Largest |position - position at the frame `origin`| in the range, by component.
  Eigen::Vector3d excursion(Body body, FrameRange range, std::size_t origin) const;

  // Whether the run counts as a capture: a pocket's by kCaptureRule. Another kind of capture system says so itself, by
  // a channel named "captured" that is 1 while the target is held: it must be 1 over the last second of the run.
  Capture capture() const;
  // "diverged at t = 3.2 s", or empty.
  std::string divergence() const;

  // Of a history that was made from a recording, for what needs its frames.
  const Recording& recording() const { return *recording_; }
  // s, length of the output interval that ends at the frame. The recorded force is the mean over it.
  double interval(std::size_t frame) const;

 private:
  Capture capture_by_channel() const;

  const RunData* data_;
  const Recording* recording_ = nullptr;
  std::string name_;
};

// The rule of capture(), in words.
extern const char* const kCaptureRule;

}  // namespace netpocket
