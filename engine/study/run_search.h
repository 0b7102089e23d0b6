#pragma once
// Runs a study that decides by the results of its points which points follow: [optimise] or [rare].

#include "engine/study/run_study.h"

namespace netpocket {

// As run_study(), in a folder that the caller holds. Besides the tables, [optimise] writes study_optimisation.csv and
// best.toml, and [rare] study_rare.csv, when the search has come to its end. Interrupted, it goes on with
// StudyOptions::resume: the points are the same.
StudyOutcome run_search(const Study& study, const std::string& folder, const StudyOptions& options,
                        const StudyCallback& progress, const std::stop_token& stop);

}  // namespace netpocket
