#include "engine/scenario/check_scenario.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/scenario/check_orbit.h"
#include "engine/scenario/check_times.h"
#include "engine/scenario/parameter_text.h"
#include "engine/scenario/system_parameters.h"
#include "engine/scenario/target_shape.h"
#include "engine/scenario/toml_value.h"

namespace netpocket {
namespace {

class Checker {
 public:
  explicit Checker(const Scenario& scenario) : s_(scenario) {}

  Diagnostics run(RunEnd end) {
    const SystemParameters* kind = find_system(s_.system);
    if (kind == nullptr) {
      add("system", fmt::format("there is no kind of capture system called {}", excerpt(s_.system)));
      return found_;
    }
    check_limits();
    if (!found_.ok()) return found_;
    if (has_table("spacecraft")) check_inertia("spacecraft.inertia", s_.spacecraft.inertia);
    check_output();
    check_fidelity();
    check_orbit(s_, found_);
    std::optional<Shape> target;
    if (has_table("target")) target = check_target();
    if (kind->check != nullptr) kind->check(s_, target ? &*target : nullptr, found_);
    if (found_.ok() && end == RunEnd::final && has_table("closing")) check_times(s_, found_);
    return found_;
  }

 private:
  void add(std::string_view key, std::string message) {
    found_.add({.key = std::string(key), .message = std::move(message)});
  }

  bool has_table(std::string_view name) const { return find_parameter_group(name, s_.system) != nullptr; }

  void check_limits() {
    for (const ParameterList& list : parameter_lists(s_.system)) {
      const std::size_t size = list.size(s_);
      if (size > kMostItems) add(list.name, fmt::format("has {} tables; {} are allowed", size, kMostItems));
    }
    if (!found_.ok()) return;
    for (const Parameter* parameter : parameters_of(s_)) {
      if (const auto problem = limit_problem(*parameter, parameter->get(s_))) add(parameter->key, *problem);
    }
  }

  // Returns the target's shape if it is valid.
  std::optional<Shape> check_target() {
    if (s_.target.inertia_from == InertiaSource::given) check_inertia("target.inertia", s_.target.inertia);
    auto shape = target_shape(s_);
    if (auto* valid = std::get_if<Shape>(&shape)) return std::move(*valid);
    found_.add(std::get<Diagnostic>(std::move(shape)));
    return std::nullopt;
  }

  // A principal moment of inertia cannot exceed the sum of the other two.
  void check_inertia(std::string_view key, const Eigen::Vector3d& inertia) {
    const double largest = inertia.maxCoeff();
    const double others = inertia.sum() - largest;
    constexpr double kRoundOff = 1e-9;  // a thin plate has largest == others
    if (largest > others * (1 + kRoundOff)) {
      add(key,
          fmt::format("the largest moment {} exceeds the sum {} of the other two, which no body has", largest, others));
    }
  }

  void check_output() {
    const double frames = s_.output.end_time * s_.output.frame_rate;
    if (frames > kLargestFrameCount) {
      add("output.frame_rate",
          fmt::format("{:.3g} frames up to output.end_time are more than {:.0f}", frames, kLargestFrameCount));
    }
    if (s_.solver.time_step > 1 / s_.output.frame_rate) {
      add("solver.time_step",
          fmt::format("must not exceed the {} s between two frames (output.frame_rate)", 1 / s_.output.frame_rate));
    }
  }

  // Its bias has been measured for pockets only.
  void check_fidelity() {
    if (s_.solver.fidelity == Fidelity::full) return;
    if (s_.system != "pocket") {
      add("solver.fidelity", fmt::format("\"draft\" is for systems of the kind pocket, not {}", s_.system));
    }
    if (s_.solver.evaluation == Evaluation::full) {
      add("solver.fidelity", "\"draft\" is for the evaluation mean_strain, not full");
    }
  }

  const Scenario& s_;
  Diagnostics found_;
};

}  // namespace

Diagnostics check_scenario(const Scenario& scenario, RunEnd end) { return Checker(scenario).run(end); }

}  // namespace netpocket
