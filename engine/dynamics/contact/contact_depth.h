#pragma once
// Depth of contacts relative to the thickness of the cords. It shows whether their springs are stiff enough.

#include <cstdint>
#include <functional>

namespace netpocket {

struct ContactDepth {
  double part = 0;  // penetration / radius of the cord, or overlap / sum of the radii
  std::int32_t element = -1;
  std::int32_t partner = -1;  // index of the body, or of the other cord's element
  double stiffness = 1;       // of the contact / of the materials

  void keep_deeper(const ContactDepth& other) {
    if (other.part > part) *this = other;
  }

  // Gives every number to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit) {
    visit(part);
    for (std::int32_t* index : {&element, &partner}) {
      double value = *index;
      visit(value);
      // A file may hold a number that is not a valid index.
      if (value >= -1 && value < 2147483647.0) *index = static_cast<std::int32_t>(value);
    }
    visit(stiffness);
  }
};

}  // namespace netpocket
