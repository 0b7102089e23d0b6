// Ties a target to libFuzzer and counts what it did.

#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/hardening/hardening_table.h"

#define NETPOCKET_TEXT_OF(name) #name
#define NETPOCKET_TEXT(name) NETPOCKET_TEXT_OF(name)

namespace {

// After as many, the table is told how far it is: a run of a million takes long, and may be ended early.
constexpr long kReportInterval = 10000;

long executions = 0;

void report(const char* outcome) {
  netpocket::test::record_hardening({"libFuzzer target " NETPOCKET_TEXT(NETPOCKET_FUZZ_TARGET) ", Clang, ASan + UBSan",
                                     std::to_string(executions) + " executions", outcome});
}

// Not reached after a crash.
void report_end() { report("no crash, no time-out, no leak"); }

}  // namespace

// HDF5's own static tables are never freed.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerInitialize(int*, char***) { return std::atexit(report_end); }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  netpocket::NETPOCKET_FUZZ_TARGET({data, size});
  if (++executions % kReportInterval == 0) report("no crash, no time-out so far");
  return 0;
}
