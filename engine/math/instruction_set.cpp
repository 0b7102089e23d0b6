#include "engine/math/instruction_set.h"

#include <cstdlib>
#include <string_view>

namespace netpocket {
namespace {

InstructionSet best_available() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2}) {
    if (has(set)) return set;
  }
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

bool has(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl");
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2");
    case InstructionSet::baseline:
      break;
  }
  return true;
}

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
