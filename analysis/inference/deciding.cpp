#include "analysis/inference/deciding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/inference/method.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

std::string_view deciding_words(const Evidence& evidence) {
  const bool is_pair = evidence.groups.size() == 2 && evidence.method->compares != Compares::means;
  return is_pair ? evidence.method->of_two : evidence.method->title;
}

std::string_view pair_test_words(const Evidence& evidence) {
  return evidence.groups.size() == 2 ? evidence.method->of_two : evidence.method->of_pair;
}

std::string_view test_of_constants_words(const Evidence& evidence) {
  return evidence.blocks > 0 ? "the sign test within blocks" : "Fisher's exact test";
}

const TestResult* deciding_test(const Evidence& evidence) {
  const auto found = std::ranges::find(evidence.tests, true, &TestResult::decides);
  return found == evidence.tests.end() ? nullptr : &*found;
}

double standing(const Evidence& evidence, const GroupEvidence& group) {
  const double rank = !evidence.ranks_decide()           ? not_defined
                      : evidence.decides_within_blocks() ? group.average_rank
                                                         : group.mean_rank;
  if (std::isfinite(rank)) return rank;
  const double mean = evidence.better == Better::smaller ? group.described.mean : -group.described.mean;
  return std::isfinite(mean) ? mean : std::numeric_limits<double>::infinity();
}

std::size_t best_group(const Evidence& evidence) {
  const auto& groups = evidence.groups;
  if (evidence.contrasts.size() == 1 && evidence.contrasts[0].ahead != 0) {
    return evidence.contrasts[0].ahead > 0 ? evidence.contrasts[0].first : evidence.contrasts[0].second;
  }
  const auto worth = [&](const GroupEvidence& group) { return standing(evidence, group); };
  return static_cast<std::size_t>(std::ranges::min_element(groups, {}, worth) - groups.begin());
}

}  // namespace ikbench::inference
