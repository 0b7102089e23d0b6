#pragma once
// What every function of render/ throws: one sentence that says what cannot be drawn or written, and why.

#include <stdexcept>

namespace netpocket {

class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace netpocket
