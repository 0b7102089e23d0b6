// The program: a subcommand of gui/commands.

#include "gui/commands/command_line.h"

int main(int argc, char** argv) { return netpocket::run_command_line(argc, argv); }
