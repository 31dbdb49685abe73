// Where the numbers beside the deciding test of a pair do not go with it: an interval by another method, a mean, a
// median or a share that is for the other.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// Whether the interval of the difference is on both sides of no difference, or on one; both false where there is none.
bool includes_none(const inference::Evidence& evidence, const inference::Contrast& contrast);
bool excludes_none(const inference::Evidence& evidence, const inference::Contrast& contrast);
bool mean_favours_other(const inference::Evidence& evidence, const inference::Contrast& contrast);

// "the interval of the difference between means includes zero and the median favours the other"; empty where all goes
// with the test.
std::string doubt_words(const inference::Evidence& evidence, const inference::Contrast& contrast);

// "What would change it: a new study of about 57 observations per group; ...": which other choice or data the answer
// hangs on. Empty where no pair is compared.
Sentence change_words(const inference::Evidence& evidence);

}  // namespace ikbench::report
