#pragma once
// Thrown when a figure cannot be made or written. what() is one sentence that names the figure or file.

#include <stdexcept>

namespace netpocket {

class FigureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace netpocket
