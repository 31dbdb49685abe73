// Checks for the author of a program before a study runs it: it keeps the protocol, and its claims
// are true.
#pragma once

#include <functional>
#include <string>

#include "experiments/foreign/program.hpp"

namespace ikbench::experiments {

struct CheckLine {
  std::string what;  // "the same seed gives the same answer"
  bool passed;
  std::string seen;  // what was seen; may be empty if it passed
};

// Runs all checks and tells each line as soon as it is known; without a hello it stops. True if all passed. `choice`
// names a program in the current folder, and its patience.
bool check_program(const ProgramChoice& choice, const std::function<void(const CheckLine&)>& tell);

}  // namespace ikbench::experiments
