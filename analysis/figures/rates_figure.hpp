// Shares of successes, one row each, with the marks of several series.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::figures {

struct RateSeries {
  std::string name;
  int colour = 1;                            // line style; a printed number has that of ours
  bool is_ring = false;                      // drawn like printed numbers
  std::vector<statistics::Estimate> shares;  // one per row; undefined shares and intervals are not drawn
};

struct RatesWords {
  std::string name;      // the figure's
  std::string quantity;  // "solved poses"
  std::string caption;
};

// Each series needs one share per row.
Figure rates_figure(const std::vector<std::string>& rows, const std::vector<RateSeries>& series,
                    const RatesWords& words);

}  // namespace ikbench::figures
