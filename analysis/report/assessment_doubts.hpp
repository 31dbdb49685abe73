// Reports numbers that contradict the deciding test of a pair: an interval by another method, or a mean, median or
// share that favours the other.
#pragma once

#include <string>

#include "analysis/inference/evidence.hpp"
#include "analysis/report/sentence.hpp"

namespace ikbench::report {

// Return whether the interval of the difference lies on both sides of no difference, or on one; both false if there is
// no interval.
bool includes_none(const inference::Evidence& evidence, const inference::Contrast& contrast);
bool excludes_none(const inference::Evidence& evidence, const inference::Contrast& contrast);
bool mean_favours_other(const inference::Evidence& evidence, const inference::Contrast& contrast);

// "the interval of the difference between means includes zero and the median favours the other"; empty if all numbers
// agree with the test.
std::string doubt_words(const inference::Evidence& evidence, const inference::Contrast& contrast);

// "What would change it: a new study of about 57 observations per group; ...": names the choices or data that could
// change the answer. Empty if no pair is compared.
Sentence change_words(const inference::Evidence& evidence);

}  // namespace ikbench::report
