#pragma once
// Depths at which the springs of one body's contacts with cords begin. Usually this is the surface: zero.
//
// When the stiffness of contacts changes in mid-contact, each spring keeps its energy and so takes another compression
// (THEORY.md, section 6). The difference is its offset. The offset follows a cord that moves out, so that the spring
// never pulls, and is forgotten when the cord parts from the body. While there are offsets, a holder that begins to
// touch, because the place of contact has come to it along the cord, takes the offset of its neighbours. If it has none
// in contact, its spring begins where it has not been by its own motion.
//
// Thread contract: one thread at a time.

#include <algorithm>
#include <array>
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
  double of(const Place& place) { return std::max(at(place), 0.0); }  // m
  // Offset (m) of a holder that touches, at its greatest depth (m); not more than that. `neighbours`: of the same part,
  // -1 for none. `entered`: distance (m) that it can have moved in the last step.
  double follow(const Place& place, double depth, const std::array<std::int32_t, 2>& neighbours, double entered);
  // Sets the offsets of all holders that touch.
  void set(const std::vector<std::pair<Place, double>>& offsets);
  // To be called when the offsets of all holders that touch have been followed.
  void end_step();
  void clear();

  // Gives every number of the state to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit);

 private:
  static constexpr double kApart = -1;  // of holders that do not touch, and of all while there are no offsets

  double& at(const Place& place) {
    return offsets_[static_cast<std::size_t>(place.first)][static_cast<std::size_t>(place.second)];
  }
  bool has_offset() {
    return std::ranges::any_of(places_, [this](const Place& place) { return at(place) > 0; });
  }

  std::vector<std::vector<double>> offsets_;        // m, by part and holder
  std::vector<Place> places_;                       // that touched in the last step
  std::vector<std::pair<Place, double>> followed_;  // of this step
};

}  // namespace netpocket
