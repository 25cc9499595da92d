#pragma once
/// Instruction sets of the processor: inner loops are compiled once for each and chosen at run
/// time.

namespace rollcon {

enum class InstructionSet { baseline, avx2, avx512 };

/// The best set of this processor, or the one set by force_instruction_set (for tests).
InstructionSet instruction_set();
/// Restricts later calls of instruction_set(); a set the processor lacks is lowered to the best.
void force_instruction_set(InstructionSet set);
InstructionSet best_instruction_set();

}  // namespace rollcon
