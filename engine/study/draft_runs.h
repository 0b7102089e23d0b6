#pragma once
// Tells which results of a study are drafts (scenario/fidelity.h). Thread contract: any thread may call these
// functions.

#include <string>

#include "engine/study/study.h"

namespace netpocket {

// A sentence that names the study's drafts and their measured bias, with a line break; empty when no run is a draft.
std::string draft_runs_text(const Study& study);

// The same from the records of a study's folder: what its first runs said of themselves. Errors: FileError.
std::string recorded_drafts_text(const std::string& folder);

}  // namespace netpocket
