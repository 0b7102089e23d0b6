// The program: a subcommand of gui/commands.

#include "gui/commands/command_line.h"
#include "gui/commands/standard_streams.h"

int main(int argc, char** argv) {
  netpocket::open_missing_streams();
  return netpocket::run_command_line(argc, argv);
}
