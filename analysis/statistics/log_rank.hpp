// Do several groups of censored costs have the same survival curve? The log-rank test: Mantel, Cancer Chemotherapy
// Reports 50 (1966) 163; Peto and Peto, Journal of the Royal Statistical Society A 135 (1972) 185.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/running_time.hpp"

namespace ikbench::statistics {

struct LogRank {
  double chi_squared = not_defined;
  int df = 0;                    // groups that were at risk when any trial reached the tolerance, less one
  double p = not_defined;        // upper tail
  std::vector<double> observed;  // trials that reached it, by group
  std::vector<double> expected;  // how many would have, were the groups alike
  std::string undefined;         // why there is no chi_squared; empty where there is
};

LogRank log_rank(std::span<const std::vector<CensoredCost>> groups);

}  // namespace ikbench::statistics
