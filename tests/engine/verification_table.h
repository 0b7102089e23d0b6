#pragma once
// Verification results: checks a measured number, prints it, and keeps it in the table tests/VERIFICATION.md.
//
// Normally the rows of a test must stand in the table as they are here, with a measured value that differs by no more
// than the tolerance. With the environment variable NETPOCKET_RENEW=1 the test writes its rows there instead; tests may
// run side by side.

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace netpocket::test {

struct VerificationRow {
  std::string test;  // Suite.Name
  std::string quantity;
  std::string reference;
  std::string measured;
  std::string error;
  std::string tolerance;
  std::string source;

  bool operator==(const VerificationRow&) const = default;
};

class VerificationTest : public testing::Test {
 public:
  // The running test, for checks in helper functions.
  static VerificationTest& current() { return *current_; }

  VerificationTest() { current_ = this; }

  // |measured - reference| <= tolerance. `quantity` with its unit; `source` of the reference, reason of the tolerance.
  void expect_value(const std::string& quantity, double measured, double reference, double tolerance,
                    const std::string& source);
  // |measured/reference - 1| <= tolerance
  void expect_relative(const std::string& quantity, double measured, double reference, double tolerance,
                       const std::string& source);
  // 0 <= measured <= bound: the quantity is an error itself.
  void expect_below(const std::string& quantity, double measured, double bound, const std::string& source);

  void TearDown() override;

 private:
  static inline VerificationTest* current_ = nullptr;

  struct Result {
    VerificationRow row;
    double measured;
    double spread;  // how far a recorded value may be from this one
  };
  void record(VerificationRow row, double measured, double spread);

  std::vector<Result> results_;
};

}  // namespace netpocket::test
