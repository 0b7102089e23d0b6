#include "gui/commands/exit_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace netpocket {
namespace {

struct Meaning {
  ExitCode code;
  std::string_view text;
};

constexpr std::array kMeanings = {
    Meaning{ExitCode::ok, "done"},
    Meaning{ExitCode::unexpected, "a defect of netpocket"},
    Meaning{ExitCode::usage, "wrong usage: unknown command, option or name; missing or malformed value"},
    Meaning{ExitCode::bad_input, "bad input: a scenario, setting or recording is missing or not valid"},
    Meaning{ExitCode::diverged, "the simulation diverged, or reached solver.most_steps; what it reached is recorded"},
    Meaning{ExitCode::io, "a file or folder cannot be read or written"},
    Meaning{ExitCode::rendering, "a picture or video cannot be made"},
    Meaning{ExitCode::interrupted, "interrupted; what was done is kept"},
};

}  // namespace

std::string exit_code_help(std::initializer_list<ExitCode> codes) {
  std::string text = "Exit codes:\n";
  for (const Meaning& meaning : kMeanings) {
    const bool always = meaning.code == ExitCode::ok || meaning.code == ExitCode::usage;
    if (!always && std::find(codes.begin(), codes.end(), meaning.code) == codes.end()) continue;
    text += fmt::format("  {:>3}  {}\n", static_cast<int>(meaning.code), meaning.text);
  }
  return text;
}

}  // namespace netpocket
