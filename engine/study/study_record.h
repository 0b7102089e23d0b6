#pragma once
// What a study found at its points: a JSON value for each point, kept in a file of its own, and tables of all.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/recording/recording.h"
#include "engine/study/study.h"

namespace netpocket {

// One point: {"point" (1, 2, ...), "place", "draw" (of the ensemble; else 0), "settings" {key: TOML text}, "identity",
// "refused" (why it was not run; empty when it was), "runs" [summary_json with "variant" and "file" in front],
// "findings" as findings_json}.
using StudyRecord = nlohmann::ordered_json;

// What a record depends on: the program and the complete scenarios of the point's variants, with the meshes that they
// name, as 16 digits.
std::string point_identity(const std::vector<Scenario>& scenarios, const std::string& program);

StudyRecord refused_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                           const std::string& reason);
// `recordings`: one for each variant, in their order.
StudyRecord run_record(std::size_t index, const StudyPoint& point, const std::string& identity,
                       const std::vector<NamedSettings>& variants, const std::vector<Recording>& recordings);

// "points/0001.json" below the study's folder.
std::string record_path(const std::string& folder, std::size_t index);
// Nothing when there is no such record, or none of this identity.
std::optional<StudyRecord> load_record(const std::string& path, const std::string& identity);

// One row for each run, under a line of names: point, place, draw, the settings that differ between points, variant,
// how it ended, the summary's numbers, and for each finding the verdict and what was found. Refused points have one
// row.
std::string study_csv(const Study& study, const std::vector<StudyRecord>& records);
// {"study", "description", "rules" {finding: rule}, "points" [records]}.
nlohmann::ordered_json study_json(const Study& study, const std::vector<StudyRecord>& records);

}  // namespace netpocket
