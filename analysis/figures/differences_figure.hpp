// A forest plot of differences between groups. Its caption names what the picture does not show.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::figures {

struct DifferenceRow {
  std::string label;                            // "BA - IK-BA"; of ratios "BA / IK-BA"
  double difference = statistics::not_defined;  // all in the unit of the quantity; or a ratio
  double low = statistics::not_defined;
  double high = statistics::not_defined;
};

struct DifferencesWords {
  std::string name;
  std::string quantity;  // "difference of means: position error [cm]"
  double level = 0.95;   // of all intervals together
  std::string method;    // "Games-Howell"
  bool are_ratios = false;
};

// A forest plot: intervals of differences; those that exclude zero (ratios: 1) are coloured.
Figure differences_figure(const std::vector<DifferenceRow>& rows, const DifferencesWords& words);

}  // namespace ikbench::figures
