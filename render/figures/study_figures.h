#pragma once
// Figures of a campaign: where captures fail, how sure their probability is, what decides it.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "engine/study/study_results.h"
#include "render/figures/figure.h"
#include "render/figures/figure_error.h"

namespace netpocket {

// Names of all figures:
//   capture_map           captures over the two inputs that decide most, with contours of the probability
//   convergence           the estimate of the probability after 1, 2, ... captures, with Wilson intervals
//   distributions         empirical distributions of what was measured
//   influence             what each input decides: the probability of capture where it is large and where it is small
//   parallel_coordinates  each capture as a line over the inputs
//   scatter_matrix        captures over each pair of the inputs that decide most
//   sensitivity           of a study with [sensitivity]: its indices, or what its screening found
//   optimisation          of a study that searches: its candidates by generation, and the best so far
//   rare_failure          of a study of a rare failure: the probabilities of its levels, with intervals
const std::vector<std::string>& study_figure_names();

// Those that the results have something for: searches have a figure of their own.
std::vector<std::string> suitable_study_figures(const StudyResults& results);

// Results that lack what a figure takes give one that says "no data". Throws FigureError on an unknown name.
Figure make_study_figure(std::string_view name, const StudyResults& results);

// What an input decides, from the captures of the study themselves: the share captured of those with the input above
// its median, less that of the others. The interval is Newcombe's for the difference of two proportions from Wilson's
// intervals (1998, Stat. Med. 17(8), doi:10.1002/(SICI)1097-0258(19980430)17:8<873::AID-SIM779>3.0.CO;2-I, method 10),
// 95 %. Unlike a Sobol index it needs no captures of its own, but sees no effect that is even about the median, so
// `spread` is the same for the distance from the median.
struct InputInfluence {
  std::size_t input = 0;  // index into StudyResults::inputs
  double difference = 0, lower = 0, upper = 0;
  double spread = 0, spread_lower = 0, spread_upper = 0;

  double size() const { return std::max(std::abs(difference), std::abs(spread)); }
};

// Largest first. Empty without judged captures.
std::vector<InputInfluence> input_influences(const StudyResults& results);

}  // namespace netpocket
