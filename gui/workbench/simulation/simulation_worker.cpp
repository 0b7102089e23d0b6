#include "gui/workbench/simulation/simulation_worker.h"

#include <utility>

#include "gui/workbench/simulation/worker_loop.h"

namespace netpocket {

SimulationWorker::SimulationWorker(std::function<void()> notify, int threads)
    : notify_(std::move(notify)),
      threads_(threads),
      thread_([this](const std::stop_token& stop) { WorkerLoop(*this, stop).run(); }) {}

SimulationWorker::~SimulationWorker() {
  thread_.request_stop();
  {
    const std::lock_guard lock(mutex_);
    interruption_.request_stop();
  }
  reports_.close();
}

void SimulationWorker::post(WorkerCommand command) {
  const std::lock_guard lock(mutex_);
  commands_.push_back(std::move(command));
  interruption_.request_stop();
  changed_.notify_one();
}

std::deque<WorkerCommand> SimulationWorker::take_commands(const std::stop_token& stop,
                                                          std::optional<Clock::time_point> deadline) {
  std::unique_lock lock(mutex_);
  const auto ready = [this] { return !commands_.empty(); };
  if (deadline) {
    changed_.wait_until(lock, stop, *deadline, ready);
  } else {
    changed_.wait(lock, stop, ready);
  }
  if (!stop.stop_requested()) interruption_ = std::stop_source();
  return std::exchange(commands_, {});
}

std::stop_token SimulationWorker::interruption() const {
  const std::lock_guard lock(mutex_);
  return interruption_.get_token();
}

void SimulationWorker::report(WorkerReport report) {
  if (reports_.push(std::move(report))) notify_();
}

}  // namespace netpocket
