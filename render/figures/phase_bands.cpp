#include "render/figures/phase_bands.h"

#include <algorithm>
#include <array>

namespace netpocket {
namespace {

// Colours of the phases of other systems, in their order.
constexpr std::array kPhaseColours = {kClosingBlue, kOrange, kGreen, kPurple};

FigureColour colour_of(const Phase& phase, std::size_t index) {
  if (phase.at_rest) return kGrey;
  if (phase.name == kClosing) return kClosingBlue;
  if (phase.name == kTowing) return kTowingRed;
  return kPhaseColours[index % kPhaseColours.size()];
}

// Each band ends where the next one begins or, at the latest, at `end` (s).
std::vector<PhaseBand> bands_of(const std::vector<Phase>& phases, double end) {
  std::vector<PhaseBand> bands;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    double last = std::min(phases[i].end, end);
    if (i + 1 < phases.size()) last = std::min(last, phases[i + 1].begin);
    if (phases[i].begin < last) bands.push_back({phases[i].begin, last, phases[i].name, colour_of(phases[i], i)});
  }
  return bands;
}

double end_of(const RunSeries& run) { return run.times().empty() ? 0 : run.times().back(); }

}  // namespace

std::vector<PhaseBand> phase_bands(const RunSeries& run) { return bands_of(run.phases, end_of(run)); }

std::vector<PhaseBand> common_phases(const std::vector<RunSeries>& runs) {
  if (runs.empty()) return {};
  double end = 0;
  std::vector<Phase> common = runs.front().phases;
  for (const RunSeries& run : runs) {
    end = std::max(end, end_of(run));
    std::erase_if(common, [&](const Phase& phase) { return std::ranges::count(run.phases, phase) == 0; });
  }
  return bands_of(common, end);
}

}  // namespace netpocket
