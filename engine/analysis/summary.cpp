#include "engine/analysis/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analysis/run_history.h"

namespace netpocket {

namespace {

// Energy (J) put into the run, to which the energy error is compared.
double energy_put_in(const RunHistory& run) {
  if (run.times().empty()) return 0;
  const auto& input = run.channel(Channel::energy_input);
  return *std::max_element(input.begin(), input.end()) + run.channel(Channel::energy_kinetic).front();
}

}  // namespace

std::string energy_error_text(double joules, double put_in) {
  if (put_in < kLeastComparableEnergy) {
    return fmt::format("{:.3g} J; the energy put in, {:.3g} J, is too small to compare with", joules, put_in);
  }
  return fmt::format("{:.3g} J, {:.3g} % of the energy put in", joules, 100 * joules / put_in);
}

RunSummary summarize(const RunData& data) {
  const RunHistory run(data);
  const Peak peak_y = run.peak(Channel::contact_fy, run.all());
  RunSummary summary;
  summary.captured = run.capture().verdict;
  summary.first_contact_time = run.first_contact();
  summary.peak_force = {run.peak(Channel::contact_fx, run.all()).value, peak_y.value,
                        run.peak(Channel::contact_fz, run.all()).value};
  summary.peak_time_y = peak_y.time;
  summary.impulse = run.impulse();
  constexpr double kTiny = 1e-12;  // J
  summary.energy_put_in = energy_put_in(run);
  summary.energy_error_joules = run.times().empty() ? 0 : std::abs(run.peak(Channel::energy_error, run.all()).value);
  summary.energy_error = summary.energy_error_joules / std::max(summary.energy_put_in, kTiny);
  summary.averaging_window = run.averaging_window();
  return summary;
}

}  // namespace netpocket
