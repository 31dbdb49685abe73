// Demsar's diagram of average ranks, Journal of Machine Learning Research 7 (2006) 1, Figure 1: the best to the right.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::figures {

struct CriticalDifference {
  std::string name;
  std::vector<std::string> labels;
  std::vector<double> average_ranks;  // as long as the labels; 1 is best
  double critical_difference = statistics::not_defined;
  double significance = 0.05;
  std::string method;   // "Nemenyi, 14 problems"
  std::string decides;  // the test that decides in the report, if it is another
};

// Bars join groups that do not differ.
Figure critical_difference_figure(const CriticalDifference& ranks);

}  // namespace ikbench::figures
