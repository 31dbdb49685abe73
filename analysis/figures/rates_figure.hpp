// Shares of what succeeded, a row each, with the marks of several series in it.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::figures {

struct RateSeries {
  std::string name;
  int colour = 1;                              // of the line styles; a printed number has that of ours
  bool is_ring = false;                        // as printed numbers are drawn
  std::vector<statistics::Proportion> shares;  // a row each; one that is not defined is not drawn, nor an interval
};

struct RatesWords {
  std::string name;      // the figure's
  std::string quantity;  // "solved poses"
  std::string caption;
};

// Each series has as many shares as there are rows.
Figure rates_figure(const std::vector<std::string>& rows, const std::vector<RateSeries>& series,
                    const RatesWords& words);

}  // namespace ikbench::figures
