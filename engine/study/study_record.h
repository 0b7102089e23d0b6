#pragma once
// Records of what a study found: a JSON value for each point, in its own file, and tables of all points.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/recording/recording.h"
#include "engine/study/study.h"

namespace netpocket {

// One point: {"point" (1, 2, ...), "place", "draw" (of the ensemble; else 0), "settings" {key: TOML text}, "identity",
// "refused" (why it was not run; empty when it was), "runs" [summary_json, preceded by "variant" and "file"],
// "findings" as in findings_json}.
using StudyRecord = nlohmann::ordered_json;

// Hash, as 16 hexadecimal digits, of all that a record depends on: the program, the complete scenarios of the point's
// variants, and their meshes.
std::string point_identity(const std::vector<Scenario>& scenarios, const std::string& program);

StudyRecord refused_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                           const std::string& reason);
// `recordings`: one per variant, in their order.
StudyRecord run_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                       const std::vector<NamedSettings>& variants, const std::vector<Recording>& recordings);

// Path such as "points/0001.json" in the study's folder.
std::string record_path(const std::string& folder, std::size_t index);
// The record, or nothing when there is none or it has another identity.
std::optional<StudyRecord> load_record(const std::string& path, const std::string& identity);

// A header line of names and one row per run: point, place, draw, the settings that differ between points, variant, how
// the run ended, the numbers of its summary, and for each finding the verdict and the value. Refused points have one
// row.
std::string study_csv(const Study& study, const std::vector<StudyRecord>& records);
// {"study", "description", "rules" {finding: rule}, "points" [records]}.
nlohmann::ordered_json study_json(const Study& study, const std::vector<StudyRecord>& records);

}  // namespace netpocket
