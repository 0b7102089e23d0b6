#include "engine/dynamics/step_choice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/power.h"

namespace netpocket {
namespace {

// Of the ropes' length, at which the bound of the whole is found anew.
constexpr double kChange = 0.85;
// Of the bound of straight cables, above which bends are not worth mentioning.
constexpr double kNotable = 0.98;

// Most that the part left may vary between two choices, that what happens between them needs no watching. Captures stay
// below 1.01 unless cords snap tight.
constexpr double kSteady = 1.03;
// Most that a choice gives up of the bound for what bends and strains may grow.
constexpr double kLargestLoss = 0.5;

template <typename Enum>
void visit_enum(const std::function<void(double&)>& visit, Enum& value, Enum last) {
  double number = static_cast<double>(value);
  visit(number);
  // Files hold states too: what is no member is none.
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

// For the length rounded down to a power of 1.01: seldom anything to compute, and the same whatever came before.
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
  const bool paired = std::ranges::all_of(rope.elements, [&](std::int32_t i) { return model_.elements[i].mate >= 0; });
  rope_step_ = stable_step_of_lumped_element(section, element_length, paired);
}

double StepChoice::stable_step(const std::function<RopeMotion(double)>& winding, double end) {
  const double length = winding(system_.time()).length;
  if (length < kChange * bound_length_ || kChange * length > bound_length_) {
    bound_ = system_.stable_step();
    bound_length_ = length;
  }
  find_rope_step(std::min(length, winding(end).length));
  const double now = part_left(), least = std::min(now, least_left_), most = std::max(now, most_left_);
  watches_ = most > kSteady * least;
  const double left = watches_ ? least : now;
  least_left_ = most_left_ = now;
  cause_ = rope_step_ < bound_.step ? Cause::ropes : left < kNotable ? Cause::bends : Cause::cables;
  return caution_.part() * (expected(left) * left * present_bound().step);
}

bool StepChoice::is_outgrown(double step) {
  if (!watches_) return false;
  const double left = part_left();
  least_left_ = std::min(least_left_, left);
  most_left_ = std::max(most_left_, left);
  return step > left * present_bound().step;
}

// Of straight cables and the closing ropes as short as they become until the next choice.
StableStep StepChoice::present_bound() const {
  if (rope_step_ >= bound_.step) return bound_;
  // What limits the rope's element may be damping alone: as an undamped mode of the same step bends can add to it.
  return {.step = rope_step_, .stiffness = 4 / (rope_step_ * rope_step_)};
}

// The part of that bound that bends and strains leave now.
double StepChoice::part_left() {
  const StableStep bound = present_bound();
  return system_.stable_step_as_bent(bound) / bound.step;
}

// The part of the bound that bends and strains leave until the next choice: they may go on growing as they have since
// the last one.
double StepChoice::expected(double left) {
  const double lost = std::max(0.0, 1 - left / std::exchange(left_, left));
  return 1 - std::min(lost, kLargestLoss);
}

void StepChoice::note(double step) {
  if (step >= smallest_step_) return;
  smallest_step_ = step;
  smallest_ = {cause_, bound_.limit, bound_.thread, shortening()};
}

StepChoice::Shortening StepChoice::shortening() const {
  if (caution_.part() == 1) return Shortening::none;
  return caution_.is_for_contacts() ? Shortening::contacts : Shortening::energy;
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
  for (double* value : {&bound_length_, &bound_.step, &bound_.stiffness, &bound_.damping, &rope_step_, &left_,
                        &least_left_, &most_left_, &smallest_step_}) {
    visit(*value);
  }
  visit_integer(visit, length_class_, std::numeric_limits<int>::min());
  double watches = watches_ ? 1 : 0;
  visit(watches);
  watches_ = watches != 0;
  visit_enum(visit, bound_.limit, StepLimit::kink);
  visit_integer(visit, bound_.thread, 0);
  visit_enum(visit, smallest_.cause, Cause::ropes);
  visit_enum(visit, smallest_.mode, StepLimit::kink);
  visit_integer(visit, smallest_.thread, 0);
  visit_enum(visit, smallest_.shortening, Shortening::energy);
  caution_.visit_state(visit);
}

}  // namespace netpocket
