#pragma once
// Reads what a study asks of its captures, from TOML (scenarios/studies/README.md): [estimate], [until], [sensitivity],
// [[statement]]. The study's variants must have been read. Thread contract: any thread may call it.

#include "engine/study/study.h"
#include "engine/study/toml_values.h"

namespace netpocket {

void read_campaign(const toml::table& file, Study& study, const ReportProblem& report);

}  // namespace netpocket
