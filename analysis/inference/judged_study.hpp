// A study with its evidence. Claims, summary and tables of a report share it; each evidence is computed once.
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

  // Evidence of a metric by an estimand, without the bootstrap's intervals. Times that are not comparable are only
  // described.
  const Evidence& evidence(Metric metric, results::Estimand estimand) const;
  const Evidence& evidence(Metric metric) const;  // by average_estimand(metric)

 private:
  mutable std::map<std::pair<Metric, results::Estimand>, Evidence> evidence_ = {};
};

using JudgedStudies = std::vector<std::reference_wrapper<const JudgedStudy>>;

}  // namespace ikbench::inference
