// What decides in an Evidence: the test that its plan and design chose, in words, and how good a group is by it.
#pragma once

#include <cstddef>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// The test of one pair that decides, in words; and with that of all groups that goes with it.
std::string_view pair_test_words(const Evidence& evidence);
std::string_view deciding_words(const Evidence& evidence);
// The test of two groups of one value each.
std::string_view test_of_constants_words(const Evidence& evidence);
// How good a group is by what decides: its mean rank, average rank or mean, the smaller the better; infinite where it
// is not defined.
double standing(const Evidence& evidence, const GroupEvidence& group);
// The group that what decides puts first.
std::size_t best_group(const Evidence& evidence);
// The test of all groups that goes with the pairs' deciding one; null where it was not made, or there is none.
const TestResult* deciding_test(const Evidence& evidence);

}  // namespace ikbench::inference
