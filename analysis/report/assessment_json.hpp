// Writes all numbers of an assessment as JSON, including those that tables leave out.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"

namespace ikbench::report {

std::string json_of(const inference::Evidence& evidence);

}  // namespace ikbench::report
