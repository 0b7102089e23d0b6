#include "engine/control/controller.h"

#include <algorithm>
#include <utility>

namespace netpocket {

BodyControl& Commands::body(std::int32_t body) {
  std::optional<BodyControl>& control = bodies_[static_cast<std::size_t>(body)];
  if (!control) control.emplace();
  return *control;
}

void Commands::clear() {
  std::ranges::fill(bodies_, std::nullopt);
  std::ranges::fill(ropes_, std::nullopt);
  friction_.reset();
  moments_.clear();
  released_.clear();
}

void Commands::take(Commands& other, const Measurements& measurements) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!other.bodies_[b]) continue;
    if (bodies_[b]) {
      bodies_[b]->add(*other.bodies_[b], measurements.body(static_cast<std::int32_t>(b)).attitude);
    } else {
      bodies_[b] = other.bodies_[b];
    }
  }
  for (std::size_t r = 0; r < ropes_.size(); ++r) {
    if (other.ropes_[r]) ropes_[r] = std::exchange(other.ropes_[r], std::nullopt);
  }
  if (other.friction_) friction_ = std::exchange(other.friction_, std::nullopt);
  moments_.insert(moments_.end(), other.moments_.begin(), other.moments_.end());
  other.moments_.clear();
  released_.insert(released_.end(), other.released_.begin(), other.released_.end());
  other.released_.clear();
}

void Commands::apply(CableSystem& system) const {
  if (friction_) system.set_friction(*friction_);
  for (const std::int32_t body : released_) system.release(body);
  for (const auto& [material, moment] : moments_) system.set_wrinkling_moment(material, moment);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    system.control(static_cast<std::int32_t>(b), bodies_[b].value_or(BodyControl{}));
  }
  for (std::size_t r = 0; r < ropes_.size(); ++r) {
    if (ropes_[r]) system.wind(static_cast<std::int32_t>(r), *ropes_[r]);
  }
}

void Commands::visit_state(const std::function<void(double&)>& visit) {
  for (std::optional<BodyControl>& control : bodies_) {
    double is_held = control ? 1 : 0;
    visit(is_held);
    BodyControl value = control.value_or(BodyControl{});
    value.visit_state(visit);
    control = is_held != 0 ? std::optional(value) : std::nullopt;
  }
}

}  // namespace netpocket
