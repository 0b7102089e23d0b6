#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/report.h"
#include "gui/commands/command.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"

namespace netpocket {
namespace {

struct FindingsChoice {
  std::vector<std::string> recordings;
  bool json = false;
};

}  // namespace

Action declare_findings(CLI::App& app) {
  const auto choice = std::make_shared<FindingsChoice>();
  app.add_option("RUN.h5", choice->recordings, "recordings to judge, e.g. of cases 1, 2 and 3")
      ->required()
      ->type_name("FILE");
  app.add_flag("--json", choice->json, "for programs");
  app.footer(
      R"(The findings F1 to F11 are those of Tang et al., Appl. Sci. 2023, 13, 10377, each decided by a rule from the
recordings; --json states the rules.

Examples:
  netpocket findings case1.h5 case2.h5 case3.h5
  netpocket findings case1.h5 case2.h5 case3.h5 --json

)" + exit_code_help({ExitCode::bad_input}));
  return [choice](const std::string&) {
    const std::vector<Recording> recordings = open_recordings(choice->recordings);
    const auto findings = evaluate_findings(pointers(recordings));
    print(choice->json ? findings_json(findings).dump(2) + "\n" : findings_text(findings));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
