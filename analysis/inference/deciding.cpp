#include "analysis/inference/deciding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/tests_of_means.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

std::string_view deciding_words(const Evidence& evidence) {
  if (evidence.of_outcomes) return pair_test_words(evidence);
  constexpr std::array<std::string_view, 7> words{"the test of the design",
                                                  "One-way ANOVA with Tukey's test",
                                                  "Welch's ANOVA with the Games-Howell test",
                                                  "Kruskal-Wallis test with Brunner-Munzel and Mann-Whitney tests",
                                                  "Friedman's test with sign tests",
                                                  "Welch's ANOVA with Tamhane's test",
                                                  "Studentized bootstrap of the means"};
  if (evidence.groups.size() == 2 && evidence.ranks_decide()) return pair_test_words(evidence);
  if (evidence.decides_within_blocks() && !evidence.ranks_decide()) {
    return resamples_of(evidence) > 0 ? "Studentized bootstrap of the differences within blocks"
                                      : "Paired t-test within blocks";
  }
  return words[static_cast<std::size_t>(evidence.plan.test)];
}

std::string_view pair_test_words(const Evidence& evidence) {
  if (evidence.of_outcomes) return evidence.blocks > 0 ? "McNemar's exact test" : "Fisher's exact test";
  const bool is_of_two = evidence.groups.size() == 2;
  switch (evidence.plan.test) {
    case DecidingTest::anova:
      return is_of_two ? "Student's test" : "Tukey's test";
    case DecidingTest::kruskal_wallis:
      return "Brunner-Munzel and Mann-Whitney tests";
    case DecidingTest::friedman:
      return "sign test within blocks";
    case DecidingTest::bootstrap:
      return evidence.blocks == 0         ? "studentized bootstrap"
             : resamples_of(evidence) > 0 ? "studentized bootstrap of the differences within blocks"
                                          : "paired t-test within blocks";
    case DecidingTest::tamhane:
      return is_of_two ? "Welch's test" : "Tamhane's test";
    default:
      return is_of_two ? "Welch's test" : "Games-Howell test";
  }
}

std::string_view test_of_constants_words(const Evidence& evidence) {
  return evidence.blocks > 0 ? "the sign test within blocks" : "Fisher's exact test";
}

const TestResult* deciding_test(const Evidence& evidence) {
  if (evidence.of_outcomes) return evidence.test(cochran_name);
  switch (evidence.plan.test) {
    case DecidingTest::anova:
      return evidence.test(anova_name);
    case DecidingTest::kruskal_wallis:
      return evidence.test(kruskal_wallis_name);
    case DecidingTest::friedman:
      return evidence.test(iman_davenport_name);
    case DecidingTest::bootstrap:
      return nullptr;
    default:
      return evidence.test(welch_name);
  }
}

double standing(const Evidence& evidence, const GroupEvidence& group) {
  const double rank = evidence.plan.test == DecidingTest::friedman         ? group.average_rank
                      : evidence.plan.test == DecidingTest::kruskal_wallis ? group.mean_rank
                                                                           : not_defined;
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

std::string_view interval_words(const Evidence& evidence) {
  if (evidence.of_outcomes) return "Newcombe's score interval, Bonferroni-corrected";
  switch (evidence.plan.test) {
    case DecidingTest::friedman:
      return "paired t-test within blocks, Bonferroni-corrected";
    case DecidingTest::anova:
      return "Tukey, pooled variance";
    case DecidingTest::tamhane:
      return "Tamhane, separate variances";
    case DecidingTest::bootstrap:
      return pair_test_words(evidence);
    default:
      return "Games-Howell, separate variances";
  }
}

}  // namespace ikbench::inference
