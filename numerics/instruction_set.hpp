// The instruction sets that have kernels, and the one in use. All give the same bits; they differ in speed.
#pragma once

#include <string_view>
#include <vector>

namespace ikbench::numerics {

enum class InstructionSet {
  portable,   // plain C++: x86-64 as it was in 2003, or any other processor
  x86_64_v3,  // AVX2 and FMA
  x86_64_v4,  // AVX-512
};

// Returns "x86-64" ("portable" on other processors), "x86-64-v3" or "x86-64-v4".
std::string_view name_of(InstructionSet set);
// Returns the instruction sets that this machine runs, the slowest first.
std::vector<InstructionSet> instruction_sets();
// Returns the instruction set in use: the fastest one, or the one that the environment variable IKBENCH_INSTRUCTION_SET
// names. Throws std::invalid_argument if this machine does not run a set of that name.
InstructionSet instruction_set();

// Defines, in a folder's namespace, kernels(InstructionSet) and kernels(): its table of kernels for a set that this
// machine runs, and for the set in use, looked up once. The brackets of (kernels) keep the functions of numerics/ out.
#ifdef __x86_64__
#define IKBENCH_RETURN_KERNELS_OF(set)                                                    \
  if ((set) == ikbench::numerics::InstructionSet::x86_64_v4) return x86_64_v4::kernels(); \
  if ((set) == ikbench::numerics::InstructionSet::x86_64_v3) return x86_64_v3::kernels(); \
  return portable::kernels()
#else
#define IKBENCH_RETURN_KERNELS_OF(set) \
  static_cast<void>(set);              \
  return portable::kernels()
#endif
#define IKBENCH_DEFINE_KERNELS                                                               \
  Kernels kernels(ikbench::numerics::InstructionSet set) { IKBENCH_RETURN_KERNELS_OF(set); } \
  const Kernels& kernels() {                                                                 \
    static const Kernels chosen = (kernels)(ikbench::numerics::instruction_set());           \
    return chosen;                                                                           \
  }

}  // namespace ikbench::numerics
