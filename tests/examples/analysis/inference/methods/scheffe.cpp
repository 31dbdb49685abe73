// Scheffe's test of means (Biometrika 40 (1953) 87): the example of docs/adding-anything.md.
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "analysis/inference/method.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::vector<Finding> scheffe_pairs(const Evidence& evidence, const Groups& groups) {
  const double level = 1 - evidence.plan.significance, between = static_cast<double>(groups.summaries.size()) - 1;
  // Tukey's test has the same differences, standard errors and degrees of freedom.
  std::vector<MeanDifference> pairs = tukey(groups.summaries, level, evidence.reference);
  for (MeanDifference& pair : pairs) {
    if (!pair.undefined.empty()) continue;
    const boost::math::fisher_f_distribution<> f(between, pair.df);
    Estimate& difference = pair.difference;
    pair.p = cdf(complement(f, std::pow(difference.value / pair.standard_error, 2) / between));
    const double reach = pair.standard_error * std::sqrt(between * quantile(f, level));
    difference.low = difference.value - reach;
    difference.high = difference.value + reach;
  }
  return of_means(evidence, pairs);
}

}  // namespace

const Method scheffe_method{.name = "scheffe",
                            .title = "Scheffe's test",
                            .of_pair = "Scheffe's test",
                            .of_two = "Student's test",
                            .interval = "Scheffe, pooled variance",
                            .source = "Scheffe, Biometrika 40 (1953) 87",
                            .corrects_all_pairs = true,
                            .pairs = scheffe_pairs};

}  // namespace ikbench::inference
