#pragma once
// The workbench as a program.

#include <stdexcept>
#include <string>

namespace netpocket {

struct WorkbenchOptions {
  std::string file;                // scenario or recording to open; empty: none
  std::string presenter = "auto";  // auto, opengl or image
  std::string version;
  std::string commit;
  std::string version_text;  // of everything, several lines
  int threads = 1;           // of a simulation
  std::string screenshot;    // writes the window as a PNG there and ends
};

// Why no window can be opened; one sentence.
class NoDisplay : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whether there is anywhere to show a window.
bool can_open_window();

// Shows the window and returns when it was closed: 0, or 1 when a screenshot was wanted and could not be written.
// Throws NoDisplay.
int run_workbench(const WorkbenchOptions& options);

}  // namespace netpocket
