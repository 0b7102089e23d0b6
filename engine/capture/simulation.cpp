#include "engine/capture/simulation.h"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "engine/capture/channels.h"
#include "engine/control/control_loop.h"
#include "engine/dynamics/stepping/step_choice.h"
#include "engine/dynamics/system/cable_system.h"
#include "engine/scenario/parameters.h"
#include "engine/scenario/strategy.h"
#include "engine/systems/capture_system.h"

namespace netpocket {
namespace {

// Numbers of steps between checks that the state is sound, and between copies of a sound state.
constexpr std::int64_t kFaultInterval = 256;
constexpr std::int64_t kCopyInterval = 16 * kFaultInterval;
// Longest interval (s) of steps of equal size.
constexpr double kLongestInterval = 0.01;
// The run has collapsed when its step is below this fraction of the first stable step. No meaningful motion gets there.
constexpr double kCollapse = 1e-3;
constexpr double kMostStepsOfInterval = 1e9;
// Largest integer up to which a double represents all integers exactly.
constexpr double kLargestCount = 9007199254740992.0;

std::string step_text(double seconds) {
  return seconds < 1e-3 ? fmt::format("{:.3g} µs", 1e6 * seconds) : fmt::format("{:.3g} ms", 1e3 * seconds);
}

// CPU time of the threads that step this system only: other runs may share the process.
double cpu_seconds(const CableSystem& system) {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) + system.helpers_cpu_seconds();
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

SystemOptions system_options(const Scenario& scenario, const SimulationOptions& options, int sectors) {
  return {scenario.solver.evaluation == Evaluation::full ? ElementEvaluation::full : ElementEvaluation::mean_strain,
          options.threads, scenario.solver.symmetry == Symmetry::automatic ? sectors : 0};
}

}  // namespace

struct Simulation::Impl {
  Impl(const Scenario& s, const SimulationOptions& options)
      : scenario(s),
        capture_system(build_capture_system(s)),
        system(std::move(capture_system.model), system_options(s, options, capture_system.sectors)),
        controls(system),
        channels(capture_system.spacecraft, capture_system.target),
        step_choice(system) {
    for (SystemController& c : capture_system.controllers) controls.add(std::move(c.controller), c.period);
    if (scenario.solver.fidelity == Fidelity::draft) step_choice.limiter().grow_under_loads();
    perturb();
  }

  Scenario scenario;
  CaptureSystem capture_system;  // its model has been moved to `system`, its controllers to `controls`
  CableSystem system;
  ControlLoop controls;
  ChannelRecorder channels;
  StepChoice step_choice;
  double time_step = 0;        // s, of the present interval
  std::int64_t interval = -1;  // index of the present interval; an output interval has one or more; -1: none begun
  std::int64_t interval_steps = 1, steps_in_interval = 0;
  double wall = 0, cpu = 0;
  std::vector<double> sound_state;  // state at step sound_step; empty: none yet
  std::int64_t sound_step = 0;
  std::int64_t checked_step = 0;             // step of the last check that passed
  std::vector<std::int64_t> snapshot_steps;  // steps at which snapshots have been taken since sound_step
  std::int64_t failed_step = 0;
  double failed_step_size = 0;  // s
  std::string defect;           // fault of a motion whose numbers are sound, since the last check; empty: none

  // Displaces the free net nodes randomly by a little, to show how asymmetry grows.
  void perturb() {
    if (scenario.solver.perturbation <= 0) return;
    std::mt19937 generator(static_cast<std::uint32_t>(scenario.solver.seed));
    std::uniform_real_distribution<double> uniform(-scenario.solver.perturbation, scenario.solver.perturbation);
    std::vector<Eigen::Vector3d> displacements(system.model().nodes.size());
    for (Eigen::Vector3d& displacement : displacements) {
      for (double& component : displacement) component = uniform(generator);
    }
    system.displace(displacements);
  }

  // Changes to the strategy of another scenario at the present time.
  void adopt(const Scenario& next) {
    scenario = next;
    sound_state.clear();  // the steps since then cannot be repeated with the new strategy
    controls.change(next);
  }

  void visit_state(const std::function<void(double&)>& visit) {
    system.visit_state(visit);
    controls.visit_state(visit);
    channels.visit_state(visit);
    step_choice.visit_state(visit);
    const auto visit_count = [&](std::int64_t& count) {
      double value = static_cast<double>(count);
      visit(value);
      // The state may come from a file. A value that is not a count is ignored.
      if (value >= -1 && value <= kLargestCount) count = static_cast<std::int64_t>(value);
    };
    visit_count(interval);
    visit_count(interval_steps);
    visit_count(steps_in_interval);
    for (double* value : {&time_step, &wall, &cpu}) visit(*value);
  }

  std::string overload_text(double depth) const {
    const std::string contact = system.deepest_contact();
    return fmt::format("{} ({:.2g} m within the last {} s)",
                       contact.empty() ? "a cord was pressed into a body" : contact, depth, kLongestInterval);
  }

  double intervals_of_frame() const { return std::ceil(1 / scenario.output.frame_rate / kLongestInterval); }

  // Adapts the step limiter to the interval that ends now.
  void end_interval() {
    StepLimiter& limiter = step_choice.limiter();
    limiter.follow_contacts();
    if (limiter.overload() > 0 && defect.empty()) defect = overload_text(limiter.overload());
    const bool frame_ends = (interval + 1) % static_cast<std::int64_t>(intervals_of_frame()) == 0;
    if (!frame_ends || scenario.solver.time_step > 0) return;
    const EnergyAudit energy = system.audit();
    limiter.follow_energy(energy.aliased, energy.strain + std::abs(energy.input) + energy.spent.total());
  }

  // Step (s) for an interval that ends at `end` (s).
  double chosen_step(double end) {
    const double step = scenario.solver.safety * step_choice.stable_step(controls.shortest_lengths(end));
    if (interval > 0) return step;
    // Initial displacements may have put energy into waves that are too short for the step.
    StepLimiter& limiter = step_choice.limiter();
    limiter.anticipate_energy(system.aliased_energy(step), system.audit().strain);
    return limiter.factor() * step;
  }

  double interval_length() const { return 1 / scenario.output.frame_rate / intervals_of_frame(); }
  double interval_end() const { return static_cast<double>(interval + 1) * interval_length(); }

  void begin_interval() {
    const double begin = interval_end();
    ++interval;
    divide(begin, interval_length());
  }

  void divide_rest() { divide(system.time(), interval_end() - system.time()); }

  // Divides the rest of the interval into equal steps. It begins at `begin` and is `length` long (s).
  void divide(double begin, double length) {
    const double end = interval_end();
    const double allowed = scenario.solver.time_step > 0 ? scenario.solver.time_step : chosen_step(end);
    const double steps = std::ceil(length / allowed);  // not a number when the state has diverged
    interval_steps =
        static_cast<std::int64_t>(steps < kMostStepsOfInterval ? std::max(1.0, steps) : kMostStepsOfInterval);
    time_step = (end - begin) / static_cast<double>(interval_steps);
    step_choice.note(time_step);
    steps_in_interval = 0;
  }

  std::vector<double> state() {
    std::vector<double> values;
    values.reserve(sound_state.size());
    visit_state([&](double& value) { values.push_back(value); });
    return values;
  }

  // Returns false if there are more or fewer numbers than the state has. It is not to be used then.
  bool set_state(std::span<const double> values) {
    std::size_t next = 0;
    visit_state([&](double& value) {
      if (next < values.size()) value = values[next];
      ++next;
    });
    defect.clear();
    return next == values.size();
  }

  void step() {
    if (interval < 0 || steps_in_interval == interval_steps) begin_interval();
    controls.before_step(time_step);
    const auto stops = [this] {
      const SafeguardCounts& counts = system.safeguards();
      return counts.stopped_blows + counts.stopped_cords;
    };
    const std::int64_t stops_before = stops();
    StepLimiter& limiter = step_choice.limiter();
    if (scenario.solver.time_step == 0 && limiter.factor() < 1) system.note_shortened_step();
    system.step(time_step, time_step * limiter.spring_factor() / limiter.factor());
    controls.after_step(time_step);
    limiter.note_penetration(system.penetration());
    const bool has_stopped = stops() > stops_before;
    if (has_stopped) limiter.note_blow();
    if (limiter.is_for_load()) limiter.note_springs(system.contact_load(), system.contact_compression());
    const bool is_resolved = limiter.note_squared_phase(system.contact_squared_phase()) && !has_stopped;
    if (++steps_in_interval == interval_steps) {
      end_interval();
    } else if (scenario.solver.time_step == 0 && (!is_resolved || step_choice.is_outgrown(time_step))) {
      divide_rest();
    }
  }

  // Describes the fault if the state is not sound. The state is then set back to the last sound one.
  std::optional<RunStatus> check() {
    auto fault = system.fault();
    if (!fault) fault = collapse();
    if (!fault && !defect.empty()) fault = defect;
    if (!fault) {
      checked_step = system.steps();
      return std::nullopt;
    }
    return diverged(find_first_fault(*fault));
  }

  // Reports cords strained so much, as before they fly apart, that the tiny steps would never reach the end.
  std::optional<std::string> collapse() const {
    const double first = scenario.solver.safety * step_choice.limiter().factor() * step_choice.first_stable_step();
    if (interval < 0 || scenario.solver.time_step > 0 || time_step > kCollapse * first) return std::nullopt;
    return fmt::format("cords are strained so far that the stable step has fallen from {:.3g} to {:.3g} s", first,
                       time_step);
  }

  RunStatus advance_while(const std::function<bool()>& goes_on, const std::stop_token& stop) {
    const double wall_before = wall_seconds(), cpu_before = cpu_seconds(system);
    RunStatus status{RunReason::finished, 0, "reached the requested time"};
    std::optional<RunStatus> failure;
    if (sound_state.empty()) keep_sound_state();
    while (!failure && goes_on()) {
      if (stop.stop_requested()) {
        status = {RunReason::stopped, 0, "stopped on request"};
        break;
      }
      if (has_no_step_left()) {
        status = limited();
        break;
      }
      step();
      if (system.steps() % kFaultInterval != 0) continue;
      failure = check();
      if (!failure && system.steps() >= sound_step + kCopyInterval) keep_sound_state();
    }
    if (!failure) failure = check();
    if (failure) status = *failure;
    status.time = system.time();
    wall += wall_seconds() - wall_before;
    cpu += cpu_seconds(system) - cpu_before;
    return status;
  }

  bool has_no_step_left() const {
    return scenario.solver.most_steps > 0 && system.steps() >= scenario.solver.most_steps;
  }

  RunStatus limited() const {
    return {RunReason::limited, system.time(),
            fmt::format("reached the limit of {} steps (solver.most_steps) at t = {:.4f} s", scenario.solver.most_steps,
                        system.time())};
  }

  void keep_sound_state() {
    sound_state = state();
    sound_step = checked_step = system.steps();
    snapshot_steps.clear();
  }

  // Finds the step that failed. Repeats the steps since the last sound copy, with the snapshots taken in between, and
  // sets the state back to the one before the failure.
  std::string find_first_fault(const std::string& latest) {
    const std::int64_t end = system.steps();
    set_state(sound_state);
    std::optional<std::string> fault;
    std::size_t next_snapshot = 0;
    while (!fault && system.steps() < end) {
      for (; next_snapshot < snapshot_steps.size() && snapshot_steps[next_snapshot] == system.steps();
           ++next_snapshot) {
        snapshot();
      }
      // The check at checked_step passed. Earlier steps may have had higher speeds for a moment but recovered.
      const bool is_suspect = system.steps() >= checked_step;
      if (is_suspect) sound_state = state();
      step();
      if (is_suspect) fault = system.fault();
    }
    failed_step = system.steps();
    failed_step_size = time_step;
    set_state(sound_state);
    keep_sound_state();
    return fault.value_or(latest);
  }

  Snapshot snapshot() {
    Snapshot result;
    result.channel_list = capture_system.structure.channels;
    result.channels.assign(result.channel_list->size(), 0.0);
    const EnergyAudit energy = system.capture(result);
    channels.fill(result, system, energy, time_step);
    if (capture_system.fill_channels) capture_system.fill_channels(system, result);
    return result;
  }

  // A likely remedy for a divergence.
  std::string advice() const {
    if (const std::string suspicion = controls.suspicion(); !suspicion.empty()) return suspicion;
    if (scenario.solver.time_step > 0) return fmt::format("try a solver.time_step below {:.3g} s", failed_step_size);
    return fmt::format("try solver.safety below {}", scenario.solver.safety);
  }

  RunStatus diverged(const std::string& fault) const {
    return {RunReason::diverged, system.time(),
            fmt::format("{} in step {} of {}, at t = {:.4f} s; {}", fault, failed_step, step_text(failed_step_size),
                        system.time(), advice())};
  }
};

Simulation::Simulation(const Scenario& scenario, const SimulationOptions& options)
    : impl_(std::make_unique<Impl>(scenario, options)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scenario& Simulation::scenario() const { return impl_->scenario; }
const Structure& Simulation::structure() const { return impl_->capture_system.structure; }
double Simulation::time() const { return impl_->system.time(); }

std::string Simulation::awaited() const {
  const auto& awaited = impl_->capture_system.awaited;
  return awaited ? awaited(time()) : "";
}

RunStatus finished_run(const Simulation& simulation) {
  const std::string awaited = simulation.awaited();
  return {RunReason::finished, simulation.time(),
          awaited.empty() ? "reached the end time" : "reached the end time; " + awaited};
}

RunStatus Simulation::advance(double until, const std::stop_token& stop) {
  // Tolerance of half a step: a sum of many steps is not exactly the time of a frame.
  return impl_->advance_while([&] { return time() + 0.5 * impl_->time_step < until; }, stop);
}

RunStatus Simulation::advance_steps(std::int64_t count, const std::stop_token& stop) {
  const std::int64_t last = impl_->system.steps() + count;
  return impl_->advance_while([&] { return impl_->system.steps() < last; }, stop);
}

void Simulation::add_controller(std::unique_ptr<Controller> controller, double period) {
  impl_->controls.add(std::move(controller), period);
  impl_->sound_state.clear();  // it lacks the state of this controller
}

Snapshot Simulation::snapshot() {
  impl_->snapshot_steps.push_back(impl_->system.steps());
  return impl_->snapshot();
}

std::vector<std::string> Simulation::change_strategy(const Scenario& wanted) {
  std::vector<std::string> need_restart;
  Scenario next = scenario();
  for (const ParameterList& list : parameter_lists(next.system)) {
    if (list.size(wanted) == list.size(next)) continue;
    if (acts_at_once(list.name, next.system)) {
      list.resize(next, list.size(wanted));
    } else {
      need_restart.emplace_back(list.name);
    }
  }
  for (const Parameter* parameter : parameters_of(next)) {
    const bool is_in_both = find_parameter(parameter->key, wanted) != nullptr;
    if (!is_in_both || parameter->get(wanted) == parameter->get(next)) continue;
    if (acts_at_once(parameter->key, next.system)) {
      parameter->set(next, parameter->get(wanted));
    } else {
      need_restart.emplace_back(parameter->key);
    }
  }
  impl_->adopt(next);
  return need_restart;
}

std::vector<double> Simulation::checkpoint() const { return impl_->state(); }

void Simulation::restore(std::span<const double> state) {
  const std::vector<double> before = checkpoint();
  if (!impl_->set_state(state)) {
    impl_->set_state(before);
    throw std::invalid_argument("the saved state does not belong to this scenario: it has another size");
  }
  impl_->sound_state.clear();
  if (const auto fault = impl_->system.fault()) {
    throw std::invalid_argument("the saved state does not belong to this scenario: " + *fault);
  }
}

SymmetryStatus Simulation::symmetry() const { return impl_->system.symmetry(); }

RunStatistics Simulation::statistics() const {
  RunStatistics result;
  result.simulated_seconds = time();
  result.wall_seconds = impl_->wall;
  result.cpu_seconds = impl_->cpu;
  result.steps = impl_->system.steps();
  result.elements = static_cast<std::int32_t>(structure().elements.size());
  result.coordinates = 3 * (structure().node_count + structure().gradient_count);
  const SolverParameters& solver = impl_->scenario.solver;
  const StepChoice& choice = impl_->step_choice;
  const double given = solver.time_step;
  result.time_step = std::isfinite(choice.smallest_step()) ? choice.smallest_step()
                     : given > 0                           ? given
                                                           : solver.safety * choice.first_stable_step();
  result.step_limit = given > 0 ? "solver.time_step" : choice.limit();
  result.evaluation = impl_->scenario.solver.evaluation == Evaluation::full ? "full" : "mean_strain";
  return result;
}

}  // namespace netpocket
