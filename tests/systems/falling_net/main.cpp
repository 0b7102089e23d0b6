// netpocket with one more kind of capture system.

#include "gui/commands/command_line.h"
#include "gui/commands/standard_streams.h"
#include "tests/systems/falling_net/falling_net.h"

int main(int argc, char** argv) {
  netpocket::open_missing_streams();
  netpocket::register_falling_net();
  return netpocket::run_command_line(argc, argv);
}
