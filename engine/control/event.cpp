#include "engine/control/event.h"

namespace netpocket {

bool Event::holds(const EventView& view) const {
  switch (condition_.kind) {
    case EventCondition::Kind::time:
      return view.time >= condition_.level;
    case EventCondition::Kind::above:
      return view.value >= condition_.level;
    case EventCondition::Kind::below:
      return view.value <= condition_.level;
    case EventCondition::Kind::target_inside:
      return view.target_inside;
  }
  return false;
}

// When the condition, which did not hold at the last look, began to hold.
double Event::crossing(const EventView& view) const {
  if (!looked_ || condition_.kind == EventCondition::Kind::target_inside) return view.time;
  if (condition_.kind == EventCondition::Kind::time) return condition_.level;
  const double part = (condition_.level - last_value_) / (view.value - last_value_);
  return last_time_ + part * (view.time - last_time_);
}

bool Event::look(const EventView& view) {
  if (happened_) return true;
  const bool held = holding_;
  holding_ = holds(view);
  if (holding_ && !held) since_ = crossing(view);
  happened_ = holding_ && view.time >= since_ + condition_.hold;
  if (happened_) time_ = since_ + condition_.hold;
  looked_ = true;
  last_time_ = view.time;
  last_value_ = view.value;
  return happened_;
}

void Event::visit_state(const NumberVisitor& visit) {
  for (bool* flag : {&looked_, &holding_, &happened_}) visit_flag(visit, *flag);
  for (double* number : {&since_, &time_, &last_time_, &last_value_}) visit(*number);
}

}  // namespace netpocket
