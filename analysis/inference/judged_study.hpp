// A study with what its plan finds of it: claims, summary and tables of one report ask it, and each answer is computed
// once.
#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The plan with the test that decides on a metric of such observations.
results::AnalysisPlan judging(results::AnalysisPlan plan, Metric metric, const Observations& observed);

class JudgedStudy : public StudyResults {
 public:
  explicit JudgedStudy(StudyResults study);

  // Of one metric by one estimand, without the bootstrap's intervals; of times that are not comparable, a description
  // alone.
  const Evidence& evidence(Metric metric, results::Estimand estimand = results::Estimand::mean) const;

 private:
  mutable std::map<std::pair<Metric, results::Estimand>, Evidence> evidence_ = {};
};

using JudgedStudies = std::vector<std::reference_wrapper<const JudgedStudy>>;

}  // namespace ikbench::inference
