// The words of an assessment: what a good reviewer would ask, answered in order.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

std::vector<Sentence> sentences_of(const inference::Evidence& evidence);

}  // namespace ikbench::report
