#pragma once
// Calls a test once for each instruction set that this processor has, the baseline first.

#include "engine/math/instruction_set.h"

namespace netpocket::test {

// The variants of a kernel: check(name, kernel) with the baseline and with each other one that can run here.
template <typename Kernel, typename Check>
void for_each_instruction_set(Kernel baseline, Kernel avx2, Kernel avx512, const Check& check) {
  check("baseline", baseline);
  if (has(InstructionSet::avx2)) check("avx2", avx2);
  if (has(InstructionSet::avx512)) check("avx512", avx512);
}

}  // namespace netpocket::test
