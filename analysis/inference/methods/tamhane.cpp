#include "analysis/inference/method.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::vector<Finding> tamhane_pairs(const Evidence& evidence, const Groups& groups) {
  return of_means(evidence, tamhane(groups.summaries, 1 - evidence.plan.significance, evidence.reference));
}

}  // namespace

const Method tamhane_method{.name = "tamhane",
                            .title = "Welch's ANOVA with Tamhane's test",
                            .of_pair = "Tamhane's test",
                            .of_two = "Welch's test",
                            .interval = "Tamhane, separate variances",
                            .source = "Tamhane, JASA 74 (1979) 471",
                            .corrects_all_pairs = true,
                            .pairs = tamhane_pairs,
                            .all = welch_of_all};

}  // namespace ikbench::inference
