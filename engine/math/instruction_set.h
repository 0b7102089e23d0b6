#pragma once
// Which variant of the vectorised kernels runs: the best one this processor has, or a lesser one named in the
// environment variable NETPOCKET_ISA (baseline, avx2, avx512), for tests. All variants give the same bits.

namespace netpocket {

enum class InstructionSet { baseline, avx2, avx512 };

// Whether this processor has it.
bool has(InstructionSet set);
// Decided once, at the first call.
InstructionSet instruction_set();
const char* to_string(InstructionSet set);

// The variant of a kernel that runs.
template <typename Kernel>
Kernel choose_variant(Kernel baseline, Kernel avx2, Kernel avx512) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512;
    case InstructionSet::avx2:
      return avx2;
    case InstructionSet::baseline:
      break;
  }
  return baseline;
}

}  // namespace netpocket
