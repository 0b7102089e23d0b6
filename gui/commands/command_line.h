#pragma once
// The program as a command line.

namespace netpocket {

// Parses the arguments, runs the chosen subcommand and returns the program's exit status (exit_code.h). Everything that
// goes wrong is said on standard error, each sentence after "netpocket: ". Nothing is thrown.
int run_command_line(int argc, const char* const* argv);

}  // namespace netpocket
