#include "numerics/instruction_set.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "base/names.hpp"

namespace ikbench::numerics {

std::string_view name_of(InstructionSet set) {
  if (set != InstructionSet::portable) return set == InstructionSet::x86_64_v3 ? "x86-64-v3" : "x86-64-v4";
#ifdef __x86_64__
  return "x86-64";
#else
  return "portable";
#endif
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets{InstructionSet::portable};
#ifdef __x86_64__
  // CMakeLists.txt compiles the kernels of these sets with these features (ikbench_kernels).
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  if (v3) sets.push_back(InstructionSet::x86_64_v3);
  if (v4) sets.push_back(InstructionSet::x86_64_v4);
#endif
  return sets;
}

InstructionSet instruction_set() {
  const std::vector<InstructionSet> sets = instruction_sets();
  const char* const wanted = std::getenv("IKBENCH_INSTRUCTION_SET");
  if (wanted == nullptr || *wanted == '\0') return sets.back();
  std::vector<std::string> names;
  for (const InstructionSet set : sets) {
    if (name_of(set) == wanted) return set;
    names.emplace_back(name_of(set));
  }
  throw std::invalid_argument("IKBENCH_INSTRUCTION_SET: " + base::unknown_name("instruction set", wanted, names));
}

}  // namespace ikbench::numerics
