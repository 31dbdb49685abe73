// Figures with one row per label: intervals of differences, and shares of successes.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::figures {

struct DifferenceRow {
  std::string first, second;                    // drawn as "BA - IK-BA"; of ratios "BA / IK-BA"
  double difference = statistics::not_defined;  // all in the unit of the quantity; or a ratio
  double low = statistics::not_defined;
  double high = statistics::not_defined;
};

struct DifferencesWords {
  std::string name;
  inference::NameWithUnit quantity;  // "difference: position error" in "cm"
  double level = 0.95;               // of all intervals together
  std::string method;                // "Tamhane"
  bool are_ratios = false;
  bool larger_is_better = false;
};

// A forest plot: intervals of differences; those that exclude zero (ratios: 1) are coloured. Words above say which side
// is better for which. The caption names what the picture does not show.
Figure differences_figure(const std::vector<DifferenceRow>& rows, const DifferencesWords& words);

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

// Shares of successes with the marks of several series. Each series needs one share per row.
Figure rates_figure(const std::vector<std::string>& rows, const std::vector<RateSeries>& series,
                    const RatesWords& words);

}  // namespace ikbench::figures
