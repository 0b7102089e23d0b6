#pragma once
// Depths at which the springs of one body's contacts with cords begin. Usually this is the surface: zero.
//
// When the stiffness of contacts changes in mid-contact, each spring keeps its energy and so takes another compression
// (THEORY.md, section 6). The difference is its offset. The offset follows a cord that moves out, so that the spring
// never pulls, and is forgotten when the cord parts from the body.
//
// Thread contract: one thread at a time.

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace netpocket {

class SpringOffsets {
 public:
  // For a body of this many parts and cords with this many holders of contact.
  SpringOffsets(std::size_t parts, std::size_t holders);

  using Place = std::pair<std::int32_t, std::int32_t>;  // part and holder

  // Whether all springs begin at the surface.
  bool are_zero() const { return places_.empty(); }
  double of(const Place& place) { return at(place); }  // m
  // Offset (m) of a contact at its present depth (m); not more than that.
  double follow(const Place& place, double depth);
  void set(const Place& place, double offset);
  // Forgets the offsets of all contacts that are not at `present`.
  void keep_only(std::vector<Place> present);
  void clear();

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  double& at(const Place& place) {
    return offsets_[static_cast<std::size_t>(place.first)][static_cast<std::size_t>(place.second)];
  }

  std::vector<std::vector<double>> offsets_;  // m, by part and holder
  std::vector<Place> places_;                 // of offsets that are not zero
};

}  // namespace netpocket
