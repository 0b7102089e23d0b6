#pragma once
// Which variant of the vectorised kernels runs: the best one this processor has, or a lesser one named in the
// environment variable NETPOCKET_ISA (baseline, avx2, avx512), for tests. All variants give the same bits.

namespace netpocket {

enum class InstructionSet { baseline, avx2, avx512 };

// Decided once, at the first call.
InstructionSet instruction_set();
const char* to_string(InstructionSet set);

}  // namespace netpocket
