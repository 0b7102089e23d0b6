#pragma once
// Chooses the variant of the vectorised kernels that runs. It is the best one that this processor supports. For tests,
// the environment variable NETPOCKET_ISA (baseline, avx2, avx512) can select a lesser one. All variants give the same
// bits. Any thread may call these functions.

namespace netpocket {

enum class InstructionSet { baseline, avx2, avx512 };

// Whether this processor supports the instruction set.
bool has(InstructionSet set);
// The chosen instruction set. It is decided once, at the first call.
InstructionSet instruction_set();
const char* to_string(InstructionSet set);

// The variant of a kernel that belongs to instruction_set().
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

// Declares a kernel's functions once for each variant, in a namespace of its own.
#define NETPOCKET_VARIANTS(...) \
  namespace baseline {          \
  __VA_ARGS__                   \
  }                             \
  namespace avx2 {              \
  __VA_ARGS__                   \
  }                             \
  namespace avx512 {            \
  __VA_ARGS__                   \
  }

// The variant of a kernel's function that belongs to instruction_set(); `kernel` is the namespace of the variants.
#define NETPOCKET_VARIANT_OF(kernel, function) \
  ::netpocket::choose_variant(kernel::baseline::function, kernel::avx2::function, kernel::avx512::function)
