#include "engine/dynamics/stepping/step_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/power.h"

namespace netpocket {
namespace {

// The bound of the whole model is computed again when the closing ropes' length has changed by this ratio.
constexpr double kLengthRatio = 0.85;
// Bends are named as the cause of a step when bend_factor is below this.
constexpr double kNotableBendFactor = 0.98;

// Largest ratio of bend_factor between two step choices for which it need not be monitored every step. In captures the
// ratio stays below 1.01 unless cords snap tight.
constexpr double kSteadyRatio = 1.03;
// Largest reduction of a step in anticipation of a bend_factor that goes on falling.
constexpr double kLargestAnticipation = 0.5;

template <typename Enum>
void visit_enum(const std::function<void(double&)>& visit, Enum& value, Enum last) {
  double number = static_cast<double>(value);
  visit(number);
  // A state read from a file may hold any number: one that is no enumerator is ignored.
  if (number >= 0 && number <= static_cast<double>(last)) value = static_cast<Enum>(number);
}

void visit_integer(const std::function<void(double&)>& visit, int& integer, int least) {
  double number = integer;
  visit(number);
  if (number >= least && number <= std::numeric_limits<int>::max()) integer = static_cast<int>(number);
}

}  // namespace

StepChoice::StepChoice(CableSystem& system)
    : system_(system),
      model_(system.model()),
      bound_(system.stable_step()),
      bound_length_(model_.ropes.front().motion(0).length) {}

// The length is rounded down to a power of 1.01. So there is seldom anything to compute, and the result does not depend
// on earlier lengths.
void StepChoice::find_rope_step(double length) {
  const VariableRope& rope = model_.ropes.front();
  constexpr double kRatio = 1.01;
  const int length_class =
      static_cast<int>(std::floor(logarithm(length / static_cast<double>(rope.elements.size())) / logarithm(kRatio)));
  if (length_class == std::exchange(length_class_, length_class)) return;
  const CableSection& section = model_.material_of(rope.elements.front()).section;
  const double element_length = power(kRatio, length_class);
  if (system_.evaluation() == ElementEvaluation::full) {
    rope_step_ = stable_step_of_lumped_full_element(section, element_length);
    return;
  }
  const bool paired =
      std::ranges::all_of(rope.elements, [&](std::int32_t i) { return model_.elements[i].strain_partner >= 0; });
  rope_step_ = stable_step_of_lumped_element(section, element_length, paired);
}

double StepChoice::stable_step(const std::function<RopeMotion(double)>& winding, double end) {
  const double length = winding(system_.time()).length;
  if (length < kLengthRatio * bound_length_ || kLengthRatio * length > bound_length_) {
    bound_ = system_.stable_step();
    bound_length_ = length;
  }
  find_rope_step(std::min(length, winding(end).length));
  const double current = bend_factor();
  const double smallest = std::min(current, smallest_factor_), largest = std::max(current, largest_factor_);
  is_monitored_ = largest > kSteadyRatio * smallest;
  const double factor = is_monitored_ ? smallest : current;
  smallest_factor_ = largest_factor_ = current;
  cause_ = rope_step_ < bound_.step ? Cause::ropes : factor < kNotableBendFactor ? Cause::bends : Cause::cables;
  return limiter_.factor() * (anticipation(factor) * factor * straight_bound().step);
}

bool StepChoice::is_outgrown(double step) {
  if (!is_monitored_) return false;
  const double factor = bend_factor();
  smallest_factor_ = std::min(smallest_factor_, factor);
  largest_factor_ = std::max(largest_factor_, factor);
  return step > factor * straight_bound().step;
}

// The bound of straight cables, with the closing ropes as short as they become until the next choice.
StableStep StepChoice::straight_bound() const {
  if (rope_step_ >= bound_.step) return bound_;
  // The rope's bound may come from damping alone. It is expressed as an undamped mode of the same step, so that bends
  // can add their stiffness to it.
  return {.step = rope_step_, .stiffness = 4 / (rope_step_ * rope_step_)};
}

// Ratio of the stable step with the present bends and tensions to that of straight cables.
double StepChoice::bend_factor() {
  const StableStep bound = straight_bound();
  return system_.stable_step_as_bent(bound) / bound.step;
}

// Assumes that bend_factor falls by the same ratio until the next choice as it has since the last one.
double StepChoice::anticipation(double factor) {
  const double fall = std::max(0.0, 1 - factor / std::exchange(last_factor_, factor));
  return 1 - std::min(fall, kLargestAnticipation);
}

void StepChoice::note(double step) {
  if (step >= smallest_step_) return;
  smallest_step_ = step;
  smallest_ = {cause_, bound_.limit, bound_.thread, shortening()};
}

StepChoice::Shortening StepChoice::shortening() const {
  if (limiter_.factor() == 1) return Shortening::none;
  return limiter_.is_for_contacts() ? Shortening::contacts : Shortening::energy;
}

std::string StepChoice::limit() const {
  if (!std::isfinite(smallest_step_)) return limit_text(model_, bound_.limit, bound_.thread);
  std::string text = smallest_.cause == Cause::ropes ? "waves in the closing ropes, the shorter the faster"
                                                     : limit_text(model_, smallest_.mode, smallest_.thread);
  if (smallest_.cause == Cause::bends) text += ", and bends of cords";
  if (smallest_.shortening == Shortening::contacts) text += "; shortened for contacts pressed deep";
  if (smallest_.shortening == Shortening::energy) text += "; shortened to keep account of the energy of short waves";
  return text;
}

void StepChoice::visit_state(const std::function<void(double&)>& visit) {
  for (double* value : {&bound_length_, &bound_.step, &bound_.stiffness, &bound_.damping, &rope_step_, &last_factor_,
                        &smallest_factor_, &largest_factor_, &smallest_step_}) {
    visit(*value);
  }
  visit_integer(visit, length_class_, std::numeric_limits<int>::min());
  double is_monitored = is_monitored_ ? 1 : 0;
  visit(is_monitored);
  is_monitored_ = is_monitored != 0;
  visit_enum(visit, bound_.limit, StepLimit::hinge);
  visit_integer(visit, bound_.thread, 0);
  visit_enum(visit, smallest_.cause, Cause::ropes);
  visit_enum(visit, smallest_.mode, StepLimit::hinge);
  visit_integer(visit, smallest_.thread, 0);
  visit_enum(visit, smallest_.shortening, Shortening::energy);
  limiter_.visit_state(visit);
}

}  // namespace netpocket
