#pragma once
// What the program's exit status means. Scripts rely on these numbers: they do not change.

#include <initializer_list>
#include <string>

namespace netpocket {

enum class ExitCode {
  ok = 0,
  unexpected = 1,     // a defect of the program
  usage = 2,          // unknown command, option or name; a missing or malformed value
  bad_input = 3,      // a scenario, setting or recording that is missing or not valid
  diverged = 4,       // the simulation became unstable or took more steps than it may; what it reached is recorded
  io = 5,             // a file or folder cannot be read or written
  rendering = 6,      // a picture or video cannot be made
  interrupted = 130,  // ended by Ctrl-C, SIGTERM or SIGHUP; what was recorded is kept
};

// One line of help for each code, with `ok` and `usage` in any case.
std::string exit_code_help(std::initializer_list<ExitCode> codes);

}  // namespace netpocket
