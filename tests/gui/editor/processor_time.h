#pragma once
// What work costs, whatever else the machine does.

#include <algorithm>
#include <ctime>
#include <vector>

namespace netpocket {

// Processor time of this thread, ms.
inline double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Median processor time of nine runs of `work`, ms.
template <typename Work>
double median_cost(Work work) {
  std::vector<double> costs;
  for (int i = 0; i < 9; ++i) {
    const double start = processor_time();
    work(i);
    costs.push_back(processor_time() - start);
  }
  std::nth_element(costs.begin(), costs.begin() + 4, costs.end());
  return costs[4];
}

}  // namespace netpocket
