#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "engine/analysis/report.h"
#include "engine/analysis/run_labels.h"
#include "gui/commands/command.h"
#include "gui/commands/recordings.h"
#include "gui/commands/standard_streams.h"

namespace netpocket {
namespace {

struct FindingsChoice {
  std::vector<std::string> recordings;
  bool json = false;
};

// By the name of the recording.
std::vector<std::pair<std::string, std::string>> drafts_of(const std::vector<Recording>& recordings) {
  std::vector<std::pair<std::string, std::string>> drafts;
  const std::vector<std::string> names = run_labels(pointers(recordings));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const std::string& draft = recordings[i].origin().draft; !draft.empty()) drafts.emplace_back(names[i], draft);
  }
  return drafts;
}

std::string text_of(const std::vector<Finding>& findings, const std::vector<Recording>& recordings) {
  std::string text = findings_text(findings);
  for (const auto& [name, draft] : drafts_of(recordings)) text += fmt::format("{} is a draft: {}\n", name, draft);
  return text;
}

std::string json_of(const std::vector<Finding>& findings, const std::vector<Recording>& recordings) {
  auto json = findings_json(findings);
  for (const auto& [name, draft] : drafts_of(recordings)) json["drafts"][name] = draft;
  return json.dump(2) + "\n";
}

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
    print(choice->json ? json_of(findings, recordings) : text_of(findings, recordings));
    return ExitCode::ok;
  };
}

}  // namespace netpocket
