// Draws the observations: a box plot and the values of each group, one row per group.
#pragma once

#include <string>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::figures {

// The axis is logarithmic if the values differ by more than 30 times.
Figure observations_figure(const inference::Observations& observations, statistics::QuantileType quartiles,
                           const std::string& name);

}  // namespace ikbench::figures
