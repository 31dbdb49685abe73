// Box plots with the values of groups, a row each.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::figures {

// The numbers of a box plot: quartiles, and whiskers to the last value within 1.5 box heights.
struct Box {
  int n = 0;
  int not_finite = 0;  // counted and ranked, but not drawable
  double q1 = statistics::not_defined;
  double median = statistics::not_defined;
  double q3 = statistics::not_defined;
  double whisker_low = statistics::not_defined;
  double whisker_high = statistics::not_defined;
};

Box box(std::span<const double> values, statistics::QuantileType type);

// Numbers of a group from elsewhere, drawn in grey below its values.
struct Mark {
  std::string group;
  double min, median, max;
  bool is_open = false;  // the minimum is somewhere below `min`: an arrow
};

// The axis is logarithmic if the values differ by more than 30 times.
Figure box_figure(const inference::Observations& observations, statistics::QuantileType quartiles,
                  const std::string& name, const std::vector<Mark>& marks = {});
// A metric of each solver. The plan gives unit and quartiles.
Figure box_figure(const inference::StudyResults& study, inference::Metric metric, const std::string& name,
                  const std::vector<Mark>& marks = {});

}  // namespace ikbench::figures
