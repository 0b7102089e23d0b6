// Ties a target to libFuzzer and counts what it did.

#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/hardening/hardening_table.h"

#define NETPOCKET_TEXT_OF(name) #name
#define NETPOCKET_TEXT(name) NETPOCKET_TEXT_OF(name)

namespace {

long executions = 0;

// A crash ends the process before this.
void report() {
  netpocket::test::record_hardening({"libFuzzer target " NETPOCKET_TEXT(NETPOCKET_FUZZ_TARGET) ", Clang, ASan + UBSan",
                                     std::to_string(executions) + " executions", "no crash, no time-out, no leak"});
}

}  // namespace

// HDF5's own static tables are never freed.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerInitialize(int*, char***) { return std::atexit(report); }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  netpocket::NETPOCKET_FUZZ_TARGET({data, size});
  ++executions;
  return 0;
}
