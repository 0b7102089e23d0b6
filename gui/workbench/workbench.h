#pragma once
// The workbench as a program.

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace netpocket {

struct WorkbenchOptions {
  std::string file;       // scenario or recording to open; empty: none
  std::string presenter;  // auto, opengl or image; empty: as the user prefers
  std::string version;
  std::string commit;
  std::string version_text;    // of everything, several lines
  std::optional<int> threads;  // of a simulation; absent: as the user prefers
  std::string screenshot;      // writes the window as a PNG there and ends
  // Called with one sentence when there turns out to be no display. Qt ends the program then: this must not return.
  std::function<void(const std::string& reason)> no_display;
};

// Why no window can be opened; one sentence.
class NoDisplay : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whether there is anywhere to show a window.
bool can_open_window();

// Shows the window and returns when it was closed.
// Throws NoDisplay, RenderError when a font is not installed, and FileError when the screenshot cannot be written.
int run_workbench(const WorkbenchOptions& options);

}  // namespace netpocket
