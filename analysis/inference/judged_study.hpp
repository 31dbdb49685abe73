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

class JudgedStudy : public StudyResults {
 public:
  explicit JudgedStudy(StudyResults study);

  // Of one metric by one estimand, without the bootstrap's intervals; of times that are not comparable, a description
  // alone.
  const Evidence& evidence(Metric metric, results::Estimand estimand) const;
  const Evidence& evidence(Metric metric) const;  // by its average (average_estimand)

 private:
  mutable std::map<std::pair<Metric, results::Estimand>, Evidence> evidence_ = {};
};

using JudgedStudies = std::vector<std::reference_wrapper<const JudgedStudy>>;

}  // namespace ikbench::inference
