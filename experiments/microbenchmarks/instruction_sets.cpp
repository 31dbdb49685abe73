// Prints the instruction sets that this machine supports, the one in use first.
#include <iostream>

#include "numerics/instruction_set.hpp"

using namespace ikbench::numerics;

int main() {
  std::cout << name_of(instruction_set()) << '\n';
  for (const InstructionSet set : instruction_sets()) {
    if (set != instruction_set()) std::cout << name_of(set) << '\n';
  }
}
