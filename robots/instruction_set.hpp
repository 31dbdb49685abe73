// The instruction sets for which there are kernels, and the one in use. All give the same bits; they differ in speed.
#pragma once

#include <string_view>
#include <vector>

namespace ikbench {

enum class InstructionSet {
  portable,   // plain C++: x86-64 as it was in 2003, or any other processor
  x86_64_v3,  // AVX2 and FMA
  x86_64_v4,  // AVX-512
};

// "x86-64" ("portable" on other processors), "x86-64-v3", "x86-64-v4".
std::string_view name_of(InstructionSet set);
// Those that this machine runs, the slowest first.
std::vector<InstructionSet> instruction_sets();
// The fastest of them, or the one that the environment variable IKBENCH_INSTRUCTION_SET names: std::invalid_argument
// where it names none of them.
InstructionSet instruction_set();

}  // namespace ikbench
