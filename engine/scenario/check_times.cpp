#include "engine/scenario/check_times.h"

#include <fmt/format.h>

#include <string>

namespace netpocket {
namespace {

class TimeChecker {
 public:
  TimeChecker(const Scenario& scenario, Diagnostics& problems)
      : s_(scenario), end_(scenario.output.end_time), found_(problems) {}

  void run() {
    const bool waits = s_.closing.starts_at != ClosingStart::time;
    if (waits && s_.closing.start >= end_) {
      add("closing.start", fmt::format("the closing never starts: it waits for its event from {:g} s on, but the run "
                                       "ends at {:g} s (output.end_time)",
                                       s_.closing.start, end_));
      return;  // nothing that follows the closing comes
    }
    if (s_.towing.mode != TowingMode::none && s_.towing.starts_at == TowingStart::closed && closing_end_ >= end_) {
      add("towing.starts_at", fmt::format("the towing never starts: the mouth is closed at {:g} s{}, but the run ends "
                                          "at {:g} s (output.end_time)",
                                          closing_end_, waits ? " at the earliest" : "", end_));
      return;
    }
    for (std::size_t i = 0; i < s_.controllers.size(); ++i) check_phase(i);
    check_deflation();
    check_target();
  }

 private:
  void add(std::string key, std::string message) { found_.add({.key = std::move(key), .message = std::move(message)}); }

  // When a phase begins, at the earliest.
  double begin_of(ControlPhase phase) const {
    switch (phase) {
      case ControlPhase::closing:
        return s_.closing.start;
      case ControlPhase::closed:
        return closing_end_;
      case ControlPhase::towing:
        return s_.towing.starts_at == TowingStart::closed ? closing_end_ : s_.towing.start;
      case ControlPhase::always:
      case ControlPhase::open:
      case ControlPhase::off:
        break;
    }
    return 0;
  }

  void check_phase(std::size_t i) {
    const double begin = begin_of(s_.controllers[i].phase);
    if (begin < end_) return;
    add(fmt::format("controller.{}.phase", i), fmt::format("the phase never comes: it begins at {:g} s, but the run "
                                                           "ends at {:g} s (output.end_time)",
                                                           begin, end_));
  }

  void check_deflation() {
    const DeflationParameters& deflation = s_.deflation;
    if (deflation.starts_at == DeflationStart::never) return;
    double begin = deflation.start;
    if (deflation.starts_at == DeflationStart::closing) begin += s_.closing.start;
    if (deflation.starts_at == DeflationStart::closed) begin += closing_end_;
    if (begin < end_) return;
    add("deflation.starts_at", fmt::format("the rods are never deflated: that starts at {:g} s, but the run ends at "
                                           "{:g} s (output.end_time)",
                                           begin, end_));
  }

  void check_target() {
    const TargetParameters& target = s_.target;
    const bool acts = target.thrust != Eigen::Vector3d::Zero() || target.torque != Eigen::Vector3d::Zero();
    if (!acts || target.acts_from < end_) return;
    add("target.acts_from", fmt::format("thrust and torque never act: the run ends at {:g} s (output.end_time)", end_));
  }

  const Scenario& s_;
  double closing_end_ = closing_end(s_.closing);
  double end_;
  Diagnostics& found_;
};

}  // namespace

double closing_end(const ClosingParameters& closing) {
  const bool by_table = closing.law == ClosingLaw::table && !closing.table.empty();
  return closing.start + (by_table ? closing.table.back().x() : closing.duration);
}

void check_times(const Scenario& scenario, Diagnostics& problems) { TimeChecker(scenario, problems).run(); }

}  // namespace netpocket
