// What the author of a program or a shared object should know before a study runs it: does it keep the protocol, and
// does it mean what it says?
#pragma once

#include <functional>
#include <string>

#include "experiments/foreign/program.hpp"

namespace ikbench::experiments {

struct CheckLine {
  std::string what;  // "the same seed gives the same answer"
  bool passed;
  std::string seen;  // what was seen; of what passed perhaps nothing
};

// Runs all checks and tells each line as soon as it is known; with no hello there is nothing more to check. Whether all
// passed. `choice` has a program or a shared object, in the current folder, and a patience.
bool check_program(const ProgramChoice& choice, const std::function<void(const CheckLine&)>& tell);

}  // namespace ikbench::experiments
