#pragma once
// Records of what a study found: a JSON value for each point.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/recording/recording.h"
#include "engine/study/study.h"

namespace netpocket {

// One point: {"point" (1, 2, ...), "outcome" ("done", "diverged": a run of it, "limited": likewise, by its
// number of steps, "refused"), "identity", "place", "draw"
// (of the ensemble; else 0), "settings" {key: TOML text}, "refused" (why it was not run; empty when it was), "runs" [as
// measured_run()], "findings" as in findings_json, "timings" [{"variant", "wall_seconds", "cpu_seconds"}]}. All but the
// timings depends only on the study and the program.
using StudyRecord = nlohmann::ordered_json;

// Hash, as 16 hexadecimal digits, of all that a record depends on: the program, the complete scenarios of the point's
// variants, and their meshes.
std::string point_identity(const std::vector<Scenario>& scenarios, const std::string& program);

StudyRecord refused_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                           const std::string& reason);
// `runs`: of measured_run(), one per variant, in their order. `recordings`: likewise, of which findings are judged;
// empty when none are.
StudyRecord run_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                       std::vector<StudyRecord> runs, const std::vector<Recording>& recordings);

// Keys under which "used" of a run has the values of the uncertain inputs: those of the inputs, vectors by number.
std::vector<std::string> used_keys(const Study& study);

}  // namespace netpocket
