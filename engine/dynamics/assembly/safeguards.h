#pragma once
// How often what keeps a run sound has acted, where its steps or its model alone would not do. In an ordinary capture
// all counts stay 0.

#include <cstdint>
#include <functional>

namespace netpocket {

// Since the start. Those of places count each place in each step.
struct SafeguardCounts {
  std::int64_t shortened_steps = 0;      // steps shorter than stability asks for (step_limiter.h)
  std::int64_t limited_hinges = 0;       // hinges whose damper would have driven them (hinge_kernel.h)
  std::int64_t loose_hinges = 0;         // hinges that let go of a short gradient (hinge_hold.h)
  std::int64_t stopped_blows = 0;        // cords stopped at their greatest depth in a body (contact_solver.h)
  std::int64_t unresolved_contacts = 0;  // cords on bodies whose spring is too stiff for the step (force_law.h)
  std::int64_t stopped_cords = 0;        // cords kept from passing through each other (cord_contact.h)
  std::int64_t parted_overlaps = 0;      // cords found deeper in each other than their springs are (cord_contact.h)

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

  // Gives every count to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit) {
    constexpr double kLargest = 9007199254740992.0;  // counts that a double holds exactly
    for (std::int64_t* count : {&shortened_steps, &limited_hinges, &loose_hinges, &stopped_blows, &unresolved_contacts,
                                &stopped_cords, &parted_overlaps}) {
      double value = static_cast<double>(*count);
      visit(value);
      // Files hold states too: what is no count is none.
      if (value >= 0 && value <= kLargest) *count = static_cast<std::int64_t>(value);
    }
  }
};

}  // namespace netpocket
