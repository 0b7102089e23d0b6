#pragma once
// Tells which results of a study are drafts (scenario/fidelity.h). Thread contract: any thread may call it.

#include <string>

#include "engine/study/study.h"

namespace netpocket {

// A sentence that names the study's drafts and their measured bias, with a line break; empty when no run is a draft.
std::string draft_runs_text(const Study& study);

}  // namespace netpocket
