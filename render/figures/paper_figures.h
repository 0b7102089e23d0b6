#pragma once
// The figures of Tang et al., Appl. Sci. 2023, 13, 10377, and two more that show whether a run can be trusted. For one
// run or several: forces and positions by phase get panels side by side, everything else is drawn over each other.

#include <string>
#include <string_view>
#include <vector>

#include "render/figures/figure.h"
#include "render/figures/figure_error.h"
#include "render/figures/run_series.h"

namespace netpocket {

// Names of all figures, in the paper's order:
//   figure03_closing              distance between adjacent rod tips and its speed, commanded and measured
//   figure05_force                contact force components on the target
//   figure06_position             Y and X, Z of target and spacecraft; several runs over each other
//   figure09_force                as figure05_force; the paper uses it for cases 2 and 3
//   figure10_target_position      Y by phase and X, Z of the target, one row for each run
//   figure11_spacecraft_position  the same for the spacecraft
//   energy                        energy balance and its error
//   tension                       largest net tension and closing rope tension
//   control_loops                 control loops of the run (control_loops.h)
//   own_channels                  channels that only this kind of capture system has (own_channels.h)
const std::vector<std::string>& figure_names();

// The figures that suit these runs: those for which at least one run has the channels; forces as Figure 5 for one run,
// as Figure 9 for several.
std::vector<std::string> default_figure_names(const std::vector<RunSeries>& runs);

// Runs without data, or none at all, give a figure that says "no data". Throws FigureError on an unknown name, with the
// nearest valid one.
Figure make_figure(std::string_view name, const std::vector<RunSeries>& runs);

}  // namespace netpocket
