#pragma once
// Waiting for what the event loop brings.

#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <functional>

namespace netpocket {

// Processes events until the condition holds; false after `seconds`. A stretch in which this process was not served
// counts as a tenth of a second at most, so that a busy machine, or one that stands still, does not end the wait.
inline bool wait_patiently(const std::function<bool()>& condition, double seconds = 30) {
  constexpr int kSlice = 5;      // ms
  constexpr qint64 kMost = 100;  // ms
  QElapsedTimer slice;
  slice.start();
  for (qint64 waited = 0; !condition(); waited += std::min(slice.restart(), kMost)) {
    if (static_cast<double>(waited) > 1000 * seconds) return false;
    QTest::qWait(kSlice);
  }
  return true;
}

}  // namespace netpocket
