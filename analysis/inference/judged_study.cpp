#include "analysis/inference/judged_study.hpp"

#include <utility>

#include "analysis/inference/design.hpp"

namespace ikbench::inference {

JudgedStudy::JudgedStudy(StudyResults study) : StudyResults(std::move(study)) {}

const Evidence& JudgedStudy::evidence(Metric metric, results::Estimand estimand) const {
  const std::pair asked{metric, estimand};
  const auto known = evidence_.find(asked);
  if (known != evidence_.end()) return known->second;
  const Observations observed = observations(*this, metric, estimand);
  const results::AnalysisPlan possible = feasible(plan, observed);
  return evidence_
      .emplace(asked, is_comparable(*this, metric) ? tested(observed, possible) : described(observed, possible))
      .first->second;
}

}  // namespace ikbench::inference
