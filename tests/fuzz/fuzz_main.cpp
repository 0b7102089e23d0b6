// Ties a target to libFuzzer and counts what it did. NETPOCKET_FUZZ_COUNT names a file that keeps the count, so that
// what a run interrupted has done adds to that of the next.

#include <cstdlib>
#include <fstream>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/hardening/hardening_table.h"

#define NETPOCKET_TEXT_OF(name) #name
#define NETPOCKET_TEXT(name) NETPOCKET_TEXT_OF(name)

namespace {

// After as many, the table is told how far it is: a run of a million takes long, and may be ended early.
constexpr long kReportInterval = 10000;

long executions = 0;

const char* count_file() { return std::getenv("NETPOCKET_FUZZ_COUNT"); }

void report(const char* outcome) {
  if (count_file() != nullptr) std::ofstream(count_file()) << executions << '\n';
  netpocket::test::record_hardening({"libFuzzer target " NETPOCKET_TEXT(NETPOCKET_FUZZ_TARGET) ", Clang, ASan + UBSan",
                                     std::to_string(executions) + " executions", outcome});
}

// Not reached after a crash.
void report_end() { report("no crash, no time-out, no leak"); }

}  // namespace

// HDF5's own static tables are never freed.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (count_file() != nullptr) std::ifstream(count_file()) >> executions;
  return std::atexit(report_end);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  netpocket::NETPOCKET_FUZZ_TARGET({data, size});
  if (++executions % kReportInterval == 0) report("no crash, no time-out so far");
  return 0;
}
