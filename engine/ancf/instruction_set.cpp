#include "engine/ancf/instruction_set.h"

#include <cstdlib>
#include <string_view>

namespace netpocket {
namespace {

InstructionSet best_available() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return InstructionSet::avx512;
  }
  if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
  return InstructionSet::baseline;
}

InstructionSet choose() {
  const InstructionSet best = best_available();
  const char* wish = std::getenv("NETPOCKET_ISA");
  if (wish == nullptr) return best;
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
    if (std::string_view(wish) == to_string(set) && set < best) return set;
  }
  return best;
}

}  // namespace

InstructionSet instruction_set() {
  static const InstructionSet chosen = choose();
  return chosen;
}

const char* to_string(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::baseline:
      break;
  }
  return "baseline";
}

}  // namespace netpocket
