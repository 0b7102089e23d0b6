#pragma once
// Summary and findings, as text for people and as JSON for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/analysis/summary.h"
#include "engine/recording/recording.h"

namespace netpocket {

// Keys: scenario, version, commit, reason, message, simulated_seconds, wall_seconds, cpu_seconds, elements,
// coordinates, steps, time_step, evaluation, frames, closing_end, captured (true, false; null when not known), capture
// (the same in words: verdict.h), first_contact_time (null without contact), peak_force {x, y, z, time_y}, impulse {x,
// y, z}, energy_error (fraction of the energy put in), energy_error_joules, energy_put_in, averaging_window,
// penetration and overlap (null, or depth, part, time, cord, partner, stiffness: soundness.h), safeguards (null, or how
// often each has acted). SI units.
nlohmann::ordered_json summary_json(const RunData& run);
std::string summary_text(const Recording& recording);

// {"findings": [{"id", "text", "rule", "cases": [{"name", "value", "holds", "verdict", "measures"}]}]}. `holds`: true,
// false, or null when there is no judgement. `verdict`: the same in words (verdict.h). `measures`: [{"name", "unit",
// "value"}].
nlohmann::ordered_json findings_json(const std::vector<Finding>& findings);
std::string findings_text(const std::vector<Finding>& findings);

}  // namespace netpocket
