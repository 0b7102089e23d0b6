#pragma once
// Counts how often the safeguards of a run have acted, where its steps or its model alone would not do. In an ordinary
// capture all counts stay 0.

#include <cstdint>
#include <functional>

namespace netpocket {

// Counts since the start. A safeguard at a place (hinge or contact) counts once for each place and step.
struct SafeguardCounts {
  std::int64_t shortened_steps = 0;      // steps shorter than stability requires (step_limiter.h)
  std::int64_t limited_hinges = 0;       // hinges whose damper would have driven the motion (hinge_kernel.h)
  std::int64_t loose_hinges = 0;         // hinges weakened at a short gradient (hinge_hold.h)
  std::int64_t stopped_blows = 0;        // cords stopped at their greatest depth in a body (contact_solver.h)
  std::int64_t unresolved_contacts = 0;  // cords on bodies whose spring is too stiff for the step (force_law.h)
  std::int64_t stopped_cords = 0;        // cords kept from passing through each other (cord_contact.h)
  std::int64_t parted_overlaps = 0;      // cords whose springs begin below the surface (cord_offsets.h)

  SafeguardCounts& operator+=(const SafeguardCounts& more) {
    shortened_steps += more.shortened_steps;
    limited_hinges += more.limited_hinges;
    loose_hinges += more.loose_hinges;
    stopped_blows += more.stopped_blows;
    unresolved_contacts += more.unresolved_contacts;
    stopped_cords += more.stopped_cords;
    parted_overlaps += more.parted_overlaps;
    return *this;
  }
  friend SafeguardCounts operator+(SafeguardCounts a, const SafeguardCounts& b) { return a += b; }
  friend SafeguardCounts operator-(const SafeguardCounts& a, const SafeguardCounts& b) { return a + b * -1; }
  friend SafeguardCounts operator*(SafeguardCounts a, std::int64_t factor) {
    for (std::int64_t* count : {&a.shortened_steps, &a.limited_hinges, &a.loose_hinges, &a.stopped_blows,
                                &a.unresolved_contacts, &a.stopped_cords, &a.parted_overlaps}) {
      *count *= factor;
    }
    return a;
  }

  // Gives every count to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit) {
    constexpr double kLargest = 9007199254740992.0;  // 2^53: a double holds counts up to this exactly
    for (std::int64_t* count : {&shortened_steps, &limited_hinges, &loose_hinges, &stopped_blows, &unresolved_contacts,
                                &stopped_cords, &parted_overlaps}) {
      double value = static_cast<double>(*count);
      visit(value);
      // A file may hold a number that is not a valid count.
      if (value >= 0 && value <= kLargest) *count = static_cast<std::int64_t>(value);
    }
  }
};

}  // namespace netpocket
