#include "support/instruction_set.hpp"

#include <algorithm>
#include <atomic>

namespace rollcon {
namespace {

std::atomic<InstructionSet> limit{InstructionSet::avx512};

}  // namespace

InstructionSet best_instruction_set() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::avx2;
#endif
  return InstructionSet::baseline;
}

InstructionSet instruction_set() {
  return std::min(best_instruction_set(), limit.load(std::memory_order_relaxed));
}

void force_instruction_set(InstructionSet set) {
  limit.store(set, std::memory_order_relaxed);
}

}  // namespace rollcon
