#include "analysis/inference/judged_study.hpp"

#include "analysis/inference/comparable.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/estimand.hpp"

namespace ikbench::inference {

using namespace results;

JudgedStudy::JudgedStudy(StudyResults study) : StudyResults(std::move(study)) {}

const Evidence& JudgedStudy::evidence(Metric metric, Estimand estimand) const {
  const std::pair asked{metric, estimand};
  const auto known = evidence_.find(asked);
  if (known != evidence_.end()) return known->second;
  const Observations observed = observations(*this, metric, estimand);
  const AnalysisPlan possible = feasible(plan, observed);
  return evidence_
      .emplace(asked,
               is_comparable(*this, metric) ? inference::evidence(observed, possible) : described(observed, possible))
      .first->second;
}

const Evidence& JudgedStudy::evidence(Metric metric) const { return evidence(metric, average_estimand(metric)); }

}  // namespace ikbench::inference
