#pragma once
// Lets one thread at a time use an object that steps without the interpreter lock: a second one gets an error.

#include <atomic>
#include <stdexcept>
#include <string>

namespace netpocket::python {

class SingleUse {
 public:
  // `what`: the object's kind, for the message. Throws std::runtime_error when another thread uses it.
  SingleUse(std::atomic<bool>& busy, const char* what) : busy_(busy) {
    if (busy_.exchange(true)) throw std::runtime_error(std::string("another thread is using this ") + what);
  }
  ~SingleUse() { busy_ = false; }
  SingleUse(const SingleUse&) = delete;
  SingleUse& operator=(const SingleUse&) = delete;

 private:
  std::atomic<bool>& busy_;
};

}  // namespace netpocket::python
