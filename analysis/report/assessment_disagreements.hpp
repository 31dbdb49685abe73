// Where the methods that an assessment shows come to another verdict than the one that decides.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// Empty where no two methods can be compared.
Sentence disagreements(const inference::Evidence& evidence);

}  // namespace ikbench::report
