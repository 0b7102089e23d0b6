#pragma once
// The phases of a capture, such as the closing of a net. Figures shade them, pictures name the present one, and the
// timeline marks where they begin and end.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace netpocket {

struct Phase {
  std::string name;      // "closing"
  double begin = 0;      // s
  double end = 0;        // s; infinite: until the end of the run
  bool at_rest = false;  // whether nothing is done in it, as between closing and towing

  bool operator==(const Phase&) const = default;
};

// Begin and end (s) of the first phase of this name; NaN if there is none.
double phase_begin(const std::vector<Phase>& phases, std::string_view name);
double phase_end(const std::vector<Phase>& phases, std::string_view name);

// Name of the last phase that has begun by `time` (s) and not yet ended; empty if there is none.
std::string phase_at(const std::vector<Phase>& phases, double time);

inline constexpr const char* kClosing = "closing";
inline constexpr const char* kTowing = "towing";

// Channel of the phase in runs whose phases begin with events: an index into kPocketPhases.
inline constexpr const char* kPhaseChannel = "capture_phase";
inline constexpr std::array<const char*, 5> kPocketPhases = {"open", kClosing, "closed", kTowing, "after towing"};

// The phases that such a channel tells, as far as they have come: a run that goes on notes frame by frame.
class PhaseHistory {
 public:
  // A frame: its time (s), later than the last one, and the value of the channel. A value that is no index counts as no
  // phase. Returns whether the phases have changed.
  bool note(double time, double value);

  // The present one has no end yet: infinite.
  const std::vector<Phase>& phases() const { return phases_; }

 private:
  std::vector<Phase> phases_;
  std::optional<double> last_;  // value of the last frame
};

// The phases of a whole channel. `times` (s) and `values` have equal lengths.
std::vector<Phase> phases_of_channel(const std::vector<double>& times, const std::vector<double>& values);

// The phases of a pocket: open, closing, closed, towing. Times in s; `closing_end` NaN: unknown; `towing_start` NaN: it
// does not tow. Recordings of version 0.1 hold only these times.
std::vector<Phase> pocket_phases(double closing_start, double closing_end, double towing_start);

}  // namespace netpocket
