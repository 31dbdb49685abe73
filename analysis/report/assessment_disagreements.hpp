// Reports methods whose verdict differs from that of the deciding method.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// Empty if no two methods can be compared.
Sentence disagreements(const inference::Evidence& evidence);

}  // namespace ikbench::report
