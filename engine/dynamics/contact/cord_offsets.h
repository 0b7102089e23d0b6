#pragma once
// Depths at which the springs of contacts between cords begin. Usually this is the surface: zero.
//
// A contact may appear deep in the overlap without having been pressed there: near a knot the places where two cords
// are nearest to each other jump, and displaced cords lie anywhere. Its spring would then release energy that nothing
// has put in. Such a contact begins relaxed: its spring begins where the contact was found. A spring that is pressed
// beyond its greatest depth yields and is relaxed as well. The offset follows cords that move apart, so that the spring
// never pulls, and is forgotten when they part.
//
// A contact continues one of the step before if it is between the same capsules or between neighbours of them.
//
// Thread contract: one thread at a time.

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

namespace netpocket {

class CordOffsets {
 public:
  // A capsule's number, and those of its neighbours on the same cord; -1 where there is none.
  struct Capsule {
    std::int32_t number, before, after;
  };
  // Numbers of the two capsules in contact, the smaller one first.
  struct Place {
    std::int32_t first = 0, second = 0;
    auto operator<=>(const Place&) const = default;
  };
  static Place place_of(const Capsule& one, const Capsule& other) {
    return {std::min(one.number, other.number), std::max(one.number, other.number)};
  }

  // Offset (m) of a contact at its present depth (m); not more than that. `entered`: depth (m) that the contact can
  // have reached by the motion of the last step.
  double follow(const Capsule& one, const Capsule& other, double depth, double entered) const;
  // To be called when a step is taken: the contacts that have overlap at the state before it.
  void begin_step() { contacts_.clear(); }
  void note(const Place& place, double offset) { contacts_.push_back({place, offset}); }
  void end_step();

  // Gives every number of the state to `visit`, which may change it. The numbers may become more or fewer.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  struct Contact {
    Place place;
    double offset;  // m
  };
  const Contact* find(const Place& place) const;

  std::vector<Contact> contacts_;  // of the step before, sorted by place
};

}  // namespace netpocket
