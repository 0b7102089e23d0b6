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
    "| test | quantity | reference | measured | error | tolerance | source and reason |\n"
    "| --- | --- | --- | --- | --- | --- | --- |\n";

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string current_test() {
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(info->test_suite_name()) + "." + info->name();
}

std::string line_of(const VerificationRow& row) {
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", row.test, row.quantity, row.reference, row.measured,
                     row.error, row.tolerance, row.source);
}

// Rows of the table in a text; lines that are no rows are passed over.
std::vector<VerificationRow> parse(const std::string& text) {
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
    if (cells.size() != 7 || cells[0] == "test" || cells[0].starts_with("---")) continue;
    rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6]});
  }
  return rows;
}

std::string read_table() {
  std::ifstream file(kPath);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Replaces the rows of one test while the file is locked against the other tests.
void renew(const std::string& test, const std::vector<VerificationRow>& own) {
  const int file = open(kPath, O_RDWR | O_CREAT, 0644);
  ASSERT_GE(file, 0) << "cannot open " << kPath;
  flock(file, LOCK_EX);
  std::vector<VerificationRow> rows = parse(read_table());
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

void VerificationTest::record(VerificationRow row, double measured, double spread) {
  row.test = current_test();
  row.measured = number(measured);
  EXPECT_EQ(std::ranges::count(row.quantity + row.source, '|'), 0) << "a cell of the table may not hold a bar";
  fmt::print("  {:<62} {:>12}  error {:>10} (tolerance {})\n", row.quantity, row.measured, row.error, row.tolerance);
  results_.push_back({row, measured, spread});
}

void VerificationTest::expect_value(const std::string& quantity, double measured, double reference, double tolerance,
                                    const std::string& source) {
  const double error = std::abs(measured - reference);
  record({"", quantity, number(reference), "", fmt::format("{:.1e}", error), fmt::format("{:.1e}", tolerance), source},
         measured, tolerance);
  EXPECT_LE(error, tolerance) << quantity << ": " << measured << " instead of " << reference;
}

void VerificationTest::expect_relative(const std::string& quantity, double measured, double reference, double tolerance,
                                       const std::string& source) {
  const double error = std::abs(measured / reference - 1);
  record({"", quantity, number(reference), "", fmt::format("{:.2g} %", 100 * error),
          fmt::format("{:.2g} %", 100 * tolerance), source},
         measured, tolerance * std::abs(reference));
  EXPECT_LE(error, tolerance) << quantity << ": " << measured << " instead of " << reference;
}

void VerificationTest::expect_below(const std::string& quantity, double measured, double bound,
                                    const std::string& source) {
  record({"", quantity, "0", "", fmt::format("{:.1e}", measured), fmt::format("{:.1e}", bound), source}, measured,
         bound);
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
  std::vector<VerificationRow> rows = parse(read_table());
  std::erase_if(rows, [&](const VerificationRow& row) { return row.test != test; });
  const char* hint = "; renew tests/VERIFICATION.md with NETPOCKET_RENEW=1";
  ASSERT_EQ(rows.size(), own.size()) << "rows of " << test << " in tests/VERIFICATION.md" << hint;
  for (std::size_t i = 0; i < own.size(); ++i) {
    // Measured values differ by what the tolerance and six digits allow; everything else is as recorded.
    EXPECT_NEAR(results_[i].measured, std::strtod(rows[i].measured.c_str(), nullptr),
                results_[i].spread + 1e-5 * std::abs(results_[i].measured))
        << own[i].quantity << hint;
    own[i].measured = rows[i].measured;
    own[i].error = rows[i].error;
    EXPECT_EQ(own[i], rows[i]) << line_of(own[i]) << line_of(rows[i]) << hint;
  }
}

}  // namespace netpocket::test
