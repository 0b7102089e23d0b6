#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "engine/scenario/check_scenario.h"
#include "engine/scenario/read_scenario.h"
#include "engine/scenario/write_scenario.h"
#include "tests/fuzz/fuzz_targets.h"

namespace netpocket {
namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

void fuzz_scenario(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const ScenarioResult result = read_scenario_text(text, "fuzz.toml");
  if (!result.ok()) {
    for (const Diagnostic& problem : result.diagnostics.list()) {
      require(!problem.message.empty(), "a problem without a message");
      require(problem.text().find('\n') == std::string::npos, "a message of several lines");
    }
    return;
  }
  // Looking for overlaps takes ten times as long as all the rest: some of the texts are enough for it.
  if (bytes.size() % 16 == 0) check_scenario(result.scenario);
  const std::string written = write_scenario_text(result.scenario);
  const ScenarioResult again = read_scenario_text(written, "written.toml");
  require(again.ok(), "what was written cannot be read");
  require(write_scenario_text(again.scenario) == written, "what was read back is another scenario");
}

}  // namespace netpocket
