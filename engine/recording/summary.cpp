#include "engine/recording/summary.h"

#include <algorithm>
#include <cmath>

#include "engine/recording/run_history.h"

namespace netpocket {

namespace {

// Largest |energy error| over the energy that the run has to account for.
double relative_energy_error(const RunHistory& run) {
  if (run.times().empty()) return 0;
  constexpr double kTiny = 1e-12;  // J
  const auto& input = run.channel(Channel::energy_input);
  const double put_in = *std::max_element(input.begin(), input.end()) + run.channel(Channel::energy_kinetic).front();
  return std::abs(run.peak(Channel::energy_error, run.all()).value) / std::max(put_in, kTiny);
}

}  // namespace

RunSummary summarize(const Recording& recording) {
  const RunHistory run(recording);
  const Peak peak_y = run.peak(Channel::contact_fy, run.all());
  RunSummary summary;
  summary.captured = run.capture().verdict;
  summary.first_contact_time = run.first_contact();
  summary.peak_force = {run.peak(Channel::contact_fx, run.all()).value, peak_y.value,
                        run.peak(Channel::contact_fz, run.all()).value};
  summary.peak_time_y = peak_y.time;
  summary.impulse = run.impulse();
  summary.energy_error = relative_energy_error(run);
  summary.averaging_window = run.averaging_window();
  return summary;
}

}  // namespace netpocket
