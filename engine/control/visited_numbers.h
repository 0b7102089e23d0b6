#pragma once
// Gives the numbers of a state to a visitor, which reads or changes them. A checkpoint is saved and restored this way.

#include <cstdint>
#include <functional>

namespace netpocket {

using NumberVisitor = std::function<void(double&)>;

// Visits every number of a range, such as a vector.
template <class Range>
void visit_numbers(const NumberVisitor& visit, Range& range) {
  for (double& number : range) visit(number);
}

// Visits a flag as 0 or 1.
inline void visit_flag(const NumberVisitor& visit, bool& flag) {
  double number = flag ? 1 : 0;
  visit(number);
  flag = number != 0;
}

// Visits a count below 2^53, which a double holds exactly. A number that is no count becomes 0.
inline void visit_count(const NumberVisitor& visit, std::uint64_t& count) {
  constexpr double kMost = 9007199254740992;
  auto number = static_cast<double>(count);
  visit(number);
  count = number >= 0 && number <= kMost ? static_cast<std::uint64_t>(number) : 0;
}

}  // namespace netpocket
