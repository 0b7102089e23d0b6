#pragma once
// Verification results: checks a measured number, prints it, and keeps it in the table tests/VERIFICATION.md.
//
// Two bands hold each row. The tolerance is physical: how far from the reference a right model may be, and why. The
// regression band is tight about what was measured when the row was written, so that a model that gets worse, or
// freezes, is noticed long before it is wrong. Normally the rows of a test must stand in the table as they are here,
// with an error inside both bands. With the environment variable NETPOCKET_RENEW=1 the test writes its rows there
// instead, with new regression bands; tests may run side by side.

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace netpocket::test {

struct VerificationRow {
  std::string test{};  // Suite.Name
  std::string quantity{};
  std::string reference{};
  std::string measured{};
  std::string error{};
  std::string tolerance{};
  std::string band{};  // "low ... high": where the error must stay
  std::string source{};

  bool operator==(const VerificationRow&) const = default;
};

struct RegressionBand {
  double low = 0;
  double high = 0;
};

// The band about an error. Errors of round-off (below 1e-9) change with the processor and have a factor of 5, and 9e-16
// at least; others a factor of 3, which holds downwards too where the measured quantity is the error itself: a system
// that does not move has none. Never beyond the tolerance.
RegressionBand regression_band(double error, double tolerance, bool quantity_is_error);

// The rows of the table in a text; lines that are no rows are passed over.
std::vector<VerificationRow> verification_rows(const std::string& text);
RegressionBand parse_band(const std::string& text);

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

  // An error as the table has it: relative errors and their tolerances in percent.
  struct Error {
    double value;
    double tolerance;
    bool is_relative;
    bool is_quantity;  // the measured number is the error itself
  };
  struct Result {
    VerificationRow row;
    Error error;
  };
  void record(VerificationRow row, double measured, const Error& error);

  std::vector<Result> results_;
};

}  // namespace netpocket::test
