#include "gui/commands/interrupt.h"

#include <unistd.h>

#include "gui/commands/exit_code.h"

namespace netpocket {

Interrupt::Interrupt() {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) sigaddset(&signals_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  waiter_ = std::jthread([this](const std::stop_token& done) { wait(done); });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void Interrupt::wait(const std::stop_token& done) {
  // How long the end of the program may be kept waiting.
  constexpr timespec kTick = {0, 20'000'000};
  while (!done.stop_requested()) {
    if (sigtimedwait(&signals_, nullptr, &kTick) < 0) continue;
    if (!source_.request_stop()) _exit(static_cast<int>(ExitCode::interrupted));
  }
}

}  // namespace netpocket
