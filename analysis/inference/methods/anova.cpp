#include "analysis/statistics/anova.hpp"

#include "analysis/inference/method.hpp"
#include "analysis/statistics/effect_size.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::optional<TestResult> anova_of_all(const Evidence&, const Groups& groups) {
  const AnovaTable table = groups.values.empty() ? anova_from_summaries(groups.summaries) : anova(groups.values);
  return TestResult{table, std::string(anova_name), "F", Role::paper, "omega^2", omega_squared(table)};
}

}  // namespace

const Method anova_method{.name = "anova",
                          .title = "One-way ANOVA with Tukey's test",
                          .of_pair = "Tukey's test",
                          .of_two = "Student's test",
                          .interval = "Tukey, pooled variance",
                          .source = "Fisher 1925; Kramer, Biometrics 12 (1956) 307",
                          .corrects_all_pairs = true,
                          .pairs = pairs_of_means<tukey>,
                          .all = anova_of_all};

}  // namespace ikbench::inference
