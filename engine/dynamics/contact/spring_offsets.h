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
#include <span>
#include <utility>
#include <vector>

namespace netpocket {

// A spring of a holder whose stiffness changes.
struct ChangingSpring {
  double share;             // of the holder's stiffness; negative where it takes back what others count twice
  double depth;             // m
  double compression;       // m, before the change
  double stiffness_before;  // N/m^1.5
  double stiffness;         // N/m^1.5, after it
};
// The offset (m) with which springs of one holder store after the change what they stored before it. 0 if they store
// less even with no offset.
double offset_of_same_energy(std::span<const ChangingSpring> springs);

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
