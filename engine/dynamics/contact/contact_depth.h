#pragma once
// How deep contacts press, against the thickness of the cords: what says whether their springs are stiff enough.

#include <cstdint>
#include <functional>

namespace netpocket {

struct ContactDepth {
  double part = 0;  // depth of a cord in a body by its radius, of two cords by the sum of theirs
  std::int32_t element = -1;
  std::int32_t partner = -1;  // body, or the other cord's element
  double stiffness = 1;       // of the contact, by that of the materials

  void keep_deeper(const ContactDepth& other) {
    if (other.part > part) *this = other;
  }

  // Gives every number to `visit`, which may change it.
  void visit_state(const std::function<void(double&)>& visit) {
    visit(part);
    for (std::int32_t* index : {&element, &partner}) {
      double value = *index;
      visit(value);
      // Files hold states too: what is no index is none.
      if (value >= -1 && value < 2147483647.0) *index = static_cast<std::int32_t>(value);
    }
    visit(stiffness);
  }
};

}  // namespace netpocket
