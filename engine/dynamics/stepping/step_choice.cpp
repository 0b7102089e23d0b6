#include "engine/dynamics/stepping/step_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/math/power.h"

namespace netpocket {
namespace {

// The bound of the whole model is computed again when a rope's length has changed by this ratio.
constexpr double kLengthRatio = 0.85;
// Bounds of rope elements are computed for lengths that are powers of this ratio.
constexpr double kClassRatio = 1.01;
// Part of a length, far above the rounding error of class_of: nearer to the end of a class only class_of decides.
constexpr double kClassMargin = 1e-10;
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
    : system_(system), model_(system.model()), bound_(system.stable_step()), ropes_(model_.ropes.size()) {
  for (std::size_t rope = 0; rope < ropes_.size(); ++rope) ropes_[rope].length_at_bound = length_of(rope);
}

double StepChoice::length_of(std::size_t rope) const {
  return system_.rope_motion(static_cast<std::int32_t>(rope)).length;
}

// Exponent of the power of kClassRatio to which a length is rounded down. Ropes of equal lengths are asked about one
// after the other.
int StepChoice::class_of(double length) {
  if (length == classified_length_) return length_class_;
  static const double ratio = logarithm(kClassRatio);
  classified_length_ = length;
  return length_class_ = static_cast<int>(std::floor(logarithm(length) / ratio));
}

// Whether a rope's elements have the bounds of those of the rope before, at equal lengths.
bool StepChoice::is_like_previous(std::size_t rope) const {
  const std::vector<std::int32_t>&own = model_.ropes[rope].elements, &other = model_.ropes[rope - 1].elements;
  return std::ranges::equal(own, other, [this](std::int32_t a, std::int32_t b) {
    const ModelElement &one = model_.elements[static_cast<std::size_t>(a)],
                       &two = model_.elements[static_cast<std::size_t>(b)];
    return one.material == two.material && (one.strain_partner < 0) == (two.strain_partner < 0);
  });
}

// The length is rounded down to a power of 1.01. So there is seldom anything to compute, and the result does not depend
// on earlier lengths.
void StepChoice::find_rope_step(std::size_t rope, double length) {
  const std::vector<std::int32_t>& elements = model_.ropes[rope].elements;
  const double of_element = length / static_cast<double>(elements.size());
  RopeBound& bound = ropes_[rope];
  if (of_element > bound.above && of_element < bound.below) return;
  const int length_class = class_of(of_element);
  if (length_class == std::exchange(bound.length_class, length_class)) return;
  if (rope > 0 && is_like_previous(rope) && ropes_[rope - 1].length_class == length_class) {
    std::tie(bound.shortest, bound.step, bound.above, bound.below) =
        std::tie(ropes_[rope - 1].shortest, ropes_[rope - 1].step, ropes_[rope - 1].above, ropes_[rope - 1].below);
    return;
  }
  const CableSection& section = model_.material_of(elements.front()).section;
  const double element_length = power(kClassRatio, length_class);
  bound.above = (1 + kClassMargin) * element_length;
  bound.below = (1 - kClassMargin) * kClassRatio * element_length;
  bound.shortest = element_length * static_cast<double>(elements.size());
  if (system_.evaluation() == ElementEvaluation::full) {
    bound.step = stable_step_of_lumped_full_element(section, element_length);
    return;
  }
  const bool paired =
      std::ranges::all_of(elements, [&](std::int32_t i) { return model_.elements[i].strain_partner >= 0; });
  bound.step = stable_step_of_lumped_element(section, element_length, paired);
}

bool StepChoice::lengths_have_changed() const {
  for (std::size_t rope = 0; rope < ropes_.size(); ++rope) {
    const double length = length_of(rope), before = ropes_[rope].length_at_bound;
    if (length < kLengthRatio * before || kLengthRatio * length > before) return true;
  }
  return false;
}

bool StepChoice::is_shorter_than_expected() const {
  for (std::size_t rope = 0; rope < ropes_.size(); ++rope) {
    if (length_of(rope) < ropes_[rope].shortest) return true;
  }
  return false;
}

double StepChoice::stable_step(std::span<const double> shortest) {
  if (lengths_have_changed()) {
    bound_ = system_.stable_step();
    for (std::size_t rope = 0; rope < ropes_.size(); ++rope) ropes_[rope].length_at_bound = length_of(rope);
  }
  rope_step_ = std::numeric_limits<double>::infinity();
  for (std::size_t rope = 0; rope < ropes_.size(); ++rope) {
    find_rope_step(rope, std::min(length_of(rope), shortest[rope]));
    if (ropes_[rope].step >= rope_step_) continue;
    rope_step_ = ropes_[rope].step;
    limiting_rope_ = static_cast<std::int32_t>(rope);
  }
  const double current = bend_factor();
  const double smallest = std::min(current, smallest_factor_), largest = std::max(current, largest_factor_);
  is_monitored_ = largest > kSteadyRatio * smallest;
  const double factor = is_monitored_ ? smallest : current;
  smallest_factor_ = largest_factor_ = current;
  cause_ = rope_step_ < bound_.step ? Cause::ropes : factor < kNotableBendFactor ? Cause::bends : Cause::cables;
  return limiter_.factor() * (anticipation(factor) * factor * straight_bound().step);
}

bool StepChoice::is_outgrown(double step) {
  if (is_shorter_than_expected()) return true;
  if (!is_monitored_) return false;
  const double factor = bend_factor();
  smallest_factor_ = std::min(smallest_factor_, factor);
  largest_factor_ = std::max(largest_factor_, factor);
  return step > factor * straight_bound().step;
}

// The bound of straight cables, with the ropes as short as they are expected to become until the next choice.
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
  smallest_ = {cause_, bound_.limit, cause_ == Cause::ropes ? limiting_rope_ : bound_.thread, shortening()};
}

StepChoice::Shortening StepChoice::shortening() const {
  if (limiter_.factor() == 1) return Shortening::none;
  return limiter_.is_for_contacts() ? Shortening::contacts : Shortening::energy;
}

std::string StepChoice::rope_limit(std::int32_t rope) const {
  const auto index = std::min(static_cast<std::size_t>(rope), model_.ropes.size() - 1);  // a file may hold any number
  const std::int32_t element = model_.ropes[index].elements.front();
  const auto group = static_cast<std::size_t>(model_.elements[static_cast<std::size_t>(element)].group);
  return fmt::format("waves in the {}, the shorter the faster", model_.element_groups[group].name);
}

std::string StepChoice::limit() const {
  if (!std::isfinite(smallest_step_)) return limit_text(model_, bound_.limit, bound_.thread);
  std::string text = smallest_.cause == Cause::ropes ? rope_limit(smallest_.thread)
                                                     : limit_text(model_, smallest_.mode, smallest_.thread);
  if (smallest_.cause == Cause::bends) text += ", and bends of cords";
  if (smallest_.shortening == Shortening::contacts) text += "; shortened for contacts pressed deep";
  if (smallest_.shortening == Shortening::energy) text += "; shortened to keep account of the energy of short waves";
  return text;
}

void StepChoice::visit_state(const std::function<void(double&)>& visit) {
  for (double* value : {&bound_.step, &bound_.stiffness, &bound_.damping, &rope_step_, &last_factor_, &smallest_factor_,
                        &largest_factor_, &smallest_step_}) {
    visit(*value);
  }
  for (RopeBound& rope : ropes_) {
    for (double* value : {&rope.length_at_bound, &rope.shortest, &rope.step}) visit(*value);
    const int length_class = rope.length_class;
    visit_integer(visit, rope.length_class, std::numeric_limits<int>::min());
    if (rope.length_class != length_class) std::tie(rope.above, rope.below) = std::pair(1.0, 0.0);
  }
  double is_monitored = is_monitored_ ? 1 : 0;
  visit(is_monitored);
  is_monitored_ = is_monitored != 0;
  visit_enum(visit, bound_.limit, StepLimit::line);
  visit_integer(visit, bound_.thread, 0);
  visit_integer(visit, limiting_rope_, 0);
  visit_enum(visit, smallest_.cause, Cause::ropes);
  visit_enum(visit, smallest_.mode, StepLimit::line);
  visit_integer(visit, smallest_.thread, 0);
  visit_enum(visit, smallest_.shortening, Shortening::energy);
  limiter_.visit_state(visit);
}

}  // namespace netpocket
