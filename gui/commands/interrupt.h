#pragma once
// Turns Ctrl-C (SIGINT), SIGTERM and the loss of the terminal (SIGHUP) into a request to stop.

#include <signal.h>

#include <stop_token>
#include <thread>

namespace netpocket {

// While it lives the first signal requests a stop; a second one ends the program at once. Make it on the main thread
// before other threads start: they inherit that the signals are not delivered to them. A signal that the program was
// started to ignore (as background jobs of scripts are) stays ignored.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return source_.get_token(); }

 private:
  void wait(const std::stop_token& done);

  sigset_t signals_;
  sigset_t mask_before_;
  std::stop_source source_;
  std::jthread waiter_;
};

}  // namespace netpocket
