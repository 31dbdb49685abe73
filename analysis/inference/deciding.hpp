// Words the test that decides in an Evidence, and ranks groups by it.
#pragma once

#include <cstddef>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Names the deciding test of a pair; deciding_words adds the test of all groups that goes with it.
std::string_view pair_test_words(const Evidence& evidence);
std::string_view deciding_words(const Evidence& evidence);
// Names the test of two groups with one value each.
std::string_view test_of_constants_words(const Evidence& evidence);
// A group's score by the deciding method: its mean rank, average rank or mean. Smaller is better; infinite if not
// defined.
double standing(const Evidence& evidence, const GroupEvidence& group);
// Index of the group with the best standing().
std::size_t best_group(const Evidence& evidence);
// The test of all groups that goes with the deciding test of pairs; null if it was not made or does not exist.
const TestResult* deciding_test(const Evidence& evidence);

}  // namespace ikbench::inference
