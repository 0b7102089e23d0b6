#include "tests/engine/verification_table.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

namespace netpocket::test {
namespace {

constexpr const char* kPath = NETPOCKET_SOURCE_DIR "/tests/VERIFICATION.md";
constexpr std::string_view kHeader =
    "# Verification results\n"
    "\n"
    "Written by the tests themselves: `NETPOCKET_RENEW=1 ctest --test-dir build -R 'Verification'` renews it; "
    "otherwise\n"
    "the tests compare what they measure with it. SI units. \"error\" is the difference to the reference, relative "
    "where\n"
    "the tolerance is given in percent, and the measured value itself where the reference is 0. Tests whose name ends\n"
    "in `Study` take minutes and run only with NETPOCKET_STUDY=1.\n"
    "\n"
    "Two bands hold each error. The tolerance is physical: how far from the reference a right model may be, for the "
    "reason in\n"
    "the last column. The regression band is tight about what was measured when the row was written: a factor of 3 up, "
    "and\n"
    "down where the quantity is an error itself (a system that does not move has none); a factor of 5 up for errors of "
    "round-off.\n"
    "A change that takes an error out of its band has to renew the row, and so to show the new error.\n"
    "\n"
    "| test | quantity | reference | measured | error | tolerance | regression band | source and reason |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- |\n";

constexpr double kRoundOff = 1e-9;
constexpr double kLeast = 9e-16;  // less than ten times the round-off of a number near 1

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string current_test() {
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(info->test_suite_name()) + "." + info->name();
}

std::string line_of(const VerificationRow& row) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.test, row.quantity, row.reference, row.measured,
                     row.error, row.tolerance, row.band, row.source);
}

std::string read_table() {
  std::ifstream file(kPath);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

RegressionBand regression_band(double error, double tolerance, bool quantity_is_error) {
  const bool round_off = error < kRoundOff;
  const double high = round_off ? std::max(5 * error, kLeast) : 3 * error;
  return {quantity_is_error && !round_off ? error / 3 : 0, std::min(high, tolerance)};
}

RegressionBand parse_band(const std::string& text) {
  const std::size_t gap = text.find(" ... ");
  if (gap == std::string::npos) return {0, -1};
  const double unit = text.ends_with('%') ? 0.01 : 1;
  return {unit * std::strtod(text.c_str(), nullptr), unit * std::strtod(text.c_str() + gap + 5, nullptr)};
}

std::vector<VerificationRow> verification_rows(const std::string& text) {
  std::vector<VerificationRow> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    for (std::size_t begin = line.find("| "); begin != std::string::npos;) {
      const std::size_t end = line.find(" |", begin + 1);
      if (end == std::string::npos) break;
      cells.push_back(line.substr(begin + 2, end - begin - 2));
      begin = line.compare(end, 3, " | ") == 0 ? end + 1 : std::string::npos;
    }
    if (cells.size() != 8 || cells[0] == "test" || cells[0].starts_with("---")) continue;
    rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6], cells[7]});
  }
  return rows;
}

namespace {

// Replaces the rows of one test while the file is locked against the other tests.
void renew(const std::string& test, const std::vector<VerificationRow>& own) {
  const int file = open(kPath, O_RDWR | O_CREAT, 0644);
  ASSERT_GE(file, 0) << "cannot open " << kPath;
  flock(file, LOCK_EX);
  std::vector<VerificationRow> rows = verification_rows(read_table());
  std::erase_if(rows, [&](const VerificationRow& row) { return row.test == test; });
  rows.insert(rows.end(), own.begin(), own.end());
  std::ranges::stable_sort(rows, {}, &VerificationRow::test);
  std::string text(kHeader);
  for (const VerificationRow& row : rows) text += line_of(row);
  const bool written = ftruncate(file, 0) == 0 && write(file, text.data(), text.size()) == std::ssize(text);
  close(file);
  EXPECT_TRUE(written) << "cannot write " << kPath;
}

}  // namespace

void VerificationTest::record(VerificationRow row, double measured, const Error& error) {
  row.test = current_test();
  row.measured = number(measured);
  const RegressionBand band = regression_band(error.value, error.tolerance, error.is_quantity);
  if (error.is_relative) {
    row.error = fmt::format("{:.2g} %", 100 * error.value);
    row.tolerance = fmt::format("{:.2g} %", 100 * error.tolerance);
    row.band = fmt::format("{:.2g} ... {:.2g} %", 100 * band.low, 100 * band.high);
  } else {
    row.error = fmt::format("{:.1e}", error.value);
    row.tolerance = fmt::format("{:.1e}", error.tolerance);
    row.band = fmt::format("{:.1e} ... {:.1e}", band.low, band.high);
  }
  EXPECT_EQ(std::ranges::count(row.quantity + row.source, '|'), 0) << "a cell of the table may not hold a bar";
  fmt::print("  {:<62} {:>12}  error {:>10} (tolerance {})\n", row.quantity, row.measured, row.error, row.tolerance);
  results_.push_back({row, error});
}

void VerificationTest::expect_value(const std::string& quantity, double measured, double reference, double tolerance,
                                    const std::string& source) {
  const double error = std::abs(measured - reference);
  record({.quantity = quantity, .reference = number(reference), .source = source}, measured,
         {error, tolerance, false, false});
  EXPECT_LE(error, tolerance) << quantity << ": " << measured << " instead of " << reference;
}

void VerificationTest::expect_relative(const std::string& quantity, double measured, double reference, double tolerance,
                                       const std::string& source) {
  const double error = std::abs(measured / reference - 1);
  record({.quantity = quantity, .reference = number(reference), .source = source}, measured,
         {error, tolerance, true, false});
  EXPECT_LE(error, tolerance) << quantity << ": " << measured << " instead of " << reference;
}

void VerificationTest::expect_below(const std::string& quantity, double measured, double bound,
                                    const std::string& source) {
  record({.quantity = quantity, .reference = "0", .source = source}, measured, {measured, bound, false, true});
  EXPECT_LE(measured, bound) << quantity;
  EXPECT_GE(measured, 0) << quantity;
}

void VerificationTest::TearDown() {
  if (results_.empty() || IsSkipped()) return;
  const std::string test = current_test();
  std::vector<VerificationRow> own;
  for (const Result& result : results_) own.push_back(result.row);
  if (std::getenv("NETPOCKET_RENEW") != nullptr) {
    if (!HasFailure()) renew(test, own);
    return;
  }
  std::vector<VerificationRow> rows = verification_rows(read_table());
  std::erase_if(rows, [&](const VerificationRow& row) { return row.test != test; });
  const char* hint = "; renew tests/VERIFICATION.md with NETPOCKET_RENEW=1";
  ASSERT_EQ(rows.size(), own.size()) << "rows of " << test << " in tests/VERIFICATION.md" << hint;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double error = results_[i].error.value;
    const RegressionBand band = parse_band(rows[i].band);
    EXPECT_TRUE(error >= band.low && error <= band.high * (1 + kRoundOff))
        << own[i].quantity << ": error " << own[i].error << " where the regression band is " << rows[i].band
        << "; it was " << rows[i].error << hint;
    // What was measured differs within the bands; everything else is as recorded.
    own[i].measured = rows[i].measured;
    own[i].error = rows[i].error;
    own[i].band = rows[i].band;
    EXPECT_EQ(own[i], rows[i]) << line_of(own[i]) << line_of(rows[i]) << hint;
  }
}

}  // namespace netpocket::test
