#pragma once
// The thread that owns the Simulation. Commands go in as messages; frames and what else happens come back as reports
// through a bounded queue: when nobody takes them, the simulation waits. No lock is held while it steps.
// Thread contract: post() and take_report() from any thread.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "gui/workbench/simulation/worker_messages.h"
#include "render/output/bounded_queue.h"

namespace netpocket {

class SimulationWorker {
 public:
  // `notify` is called on the worker's thread whenever there is a report to take.
  explicit SimulationWorker(std::function<void()> notify, int threads = 1);
  ~SimulationWorker();  // stops within an integration step
  SimulationWorker(const SimulationWorker&) = delete;
  SimulationWorker& operator=(const SimulationWorker&) = delete;

  void post(WorkerCommand command);
  std::optional<WorkerReport> take_report() { return reports_.try_pop(); }

 private:
  friend class WorkerLoop;
  using Clock = std::chrono::steady_clock;

  // Commands in order. Waits for one until `deadline`; makes the token with which the next ones interrupt a step.
  std::deque<WorkerCommand> take_commands(const std::stop_token& stop, std::optional<Clock::time_point> deadline);
  std::stop_token interruption() const;
  void report(WorkerReport report);

  static constexpr std::size_t kWaitingReports = 16;

  std::function<void()> notify_;
  int threads_;  // used by the worker's thread only
  BoundedQueue<WorkerReport> reports_{kWaitingReports};
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<WorkerCommand> commands_;
  std::stop_source interruption_;
  std::jthread thread_;  // last: it ends before the rest goes
};

}  // namespace netpocket
