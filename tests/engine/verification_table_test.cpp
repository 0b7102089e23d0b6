// The table of verification results: what its bands let through, and what the file holds.
#include "tests/engine/verification_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace netpocket::test {
namespace {

double number(const std::string& cell) { return (cell.ends_with('%') ? 0.01 : 1) * std::strtod(cell.c_str(), nullptr); }

std::vector<VerificationRow> table() {
  std::ostringstream text;
  text << std::ifstream(NETPOCKET_SOURCE_DIR "/tests/VERIFICATION.md").rdbuf();
  return verification_rows(text.str());
}

TEST(VerificationTable, BandsAreTightAboutTheError) {
  const RegressionBand measured_error = regression_band(3e-4, 1e-2, true);
  EXPECT_DOUBLE_EQ(measured_error.low, 1e-4);
  EXPECT_DOUBLE_EQ(measured_error.high, 9e-4);
  EXPECT_EQ(regression_band(3e-4, 1e-2, false).low, 0) << "a value may meet its reference better";
  EXPECT_EQ(regression_band(3e-4, 5e-4, true).high, 5e-4) << "never beyond the tolerance";
  EXPECT_DOUBLE_EQ(regression_band(1e-14, 1e-9, true).high, 5e-14);
  EXPECT_EQ(regression_band(1e-14, 1e-9, true).low, 0) << "round-off may vanish";
  EXPECT_EQ(regression_band(0, 1e-9, true).high, 9e-16);
  EXPECT_EQ(regression_band(0, 0, true).high, 0) << "what is exact stays exact";
}

TEST(VerificationTable, ReadsItsBands) {
  EXPECT_DOUBLE_EQ(parse_band("1.0e-04 ... 9.0e-04").low, 1e-4);
  EXPECT_DOUBLE_EQ(parse_band("1.0e-04 ... 9.0e-04").high, 9e-4);
  EXPECT_DOUBLE_EQ(parse_band("0 ... 1.2 %").high, 0.012);
  EXPECT_LT(parse_band("").high, 0) << "no band lets nothing through";
}

// No row lets an error through that is ten times the one that was recorded, nor one beyond the tolerance.
TEST(VerificationTable, NoRowLetsATenfoldErrorThrough) {
  const auto rows = table();
  EXPECT_GT(rows.size(), 300u);
  for (const VerificationRow& row : rows) {
    const double error = number(row.error), high = parse_band(row.band).high;
    const double tenfold = std::max(10 * error, 1e-15);  // a few units of round-off are as good as none
    const bool exact = number(row.tolerance) == 0;
    EXPECT_TRUE(exact ? high == 0 : high < tenfold) << row.test << ", " << row.quantity;
    EXPECT_LE(high, number(row.tolerance) * 1.0001) << row.test << ", " << row.quantity;
    EXPECT_LE(error, high * 1.1) << row.test << ", " << row.quantity << ": the digits of the table are few";
    EXPECT_FALSE(row.source.empty()) << row.test << ", " << row.quantity << ": the tolerance has no reason";
  }
}

}  // namespace
}  // namespace netpocket::test
