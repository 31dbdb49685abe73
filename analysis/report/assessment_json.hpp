// An assessment's numbers as JSON: every one of them, whatever the tables leave out.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"

namespace ikbench::report {

std::string json_of(const inference::Evidence& evidence);

}  // namespace ikbench::report
