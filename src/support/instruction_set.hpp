#pragma once
/// Selects among the instruction sets of the processor: inner loops are compiled once for each and chosen at run time.

/// The build makes a source for each instruction set, which defines that set's name and the names of what it compiles.
#ifndef ROLLCON_COMPILED
#define ROLLCON_SET_NAME "baseline"
#define ROLLCON_COMPILED(name) name##_baseline
#endif

namespace rollcon {

enum class InstructionSet { baseline, avx2, avx512 };

/// Returns the best set of this processor, or the one set by force_instruction_set (for tests).
InstructionSet instruction_set();
/// Restricts later calls of instruction_set(); a set the processor lacks is lowered to the best.
void force_instruction_set(InstructionSet set);
InstructionSet best_instruction_set();

/// Returns, among the kernels compiled for each set, those of `set`.
template <class Kernels>
constexpr const Kernels& chosen(InstructionSet set, const Kernels& baseline, const Kernels& avx2,
                                const Kernels& avx512) {
  return set == InstructionSet::avx512 ? avx512 : set == InstructionSet::avx2 ? avx2 : baseline;
}

}  // namespace rollcon
