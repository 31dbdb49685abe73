#include "analysis/inference/judged_study.hpp"

#include <utility>

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"

namespace ikbench::inference {

using namespace results;

// Unless the plan names a test, ranks decide of times: one interruption of the program would decide a mean.
AnalysisPlan judging(AnalysisPlan plan, Metric metric, const Observations& observed) {
  const bool is_time = info_of(metric).kind == Kind::time;
  if (is_time && plan.test == by_design) {
    plan.test = observed.blocks.empty() ? "kruskal_wallis" : "friedman";
  }
  return feasible(std::move(plan), observed);
}

JudgedStudy::JudgedStudy(StudyResults study) : StudyResults(std::move(study)) {}

const Evidence& JudgedStudy::evidence(Metric metric, Estimand estimand) const {
  const std::pair asked{metric, estimand};
  const auto known = evidence_.find(asked);
  if (known != evidence_.end()) return known->second;
  const Observations observed = observations(*this, metric, estimand);
  const AnalysisPlan possible = judging(plan, metric, observed);
  return evidence_
      .emplace(asked, is_comparable(*this, metric) ? tested(observed, possible) : described(observed, possible))
      .first->second;
}

}  // namespace ikbench::inference
