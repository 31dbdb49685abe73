// What was observed: half violin, box plot and strip of the values of each group, a row a group (Allen et al.,
// Raincloud plots, Wellcome Open Research 4:63 (2019)).
#pragma once

#include <string>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::figures {

// The values span an axis of logarithms where they differ by more than 30 times; so does the density then.
Figure raincloud_figure(const inference::Observations& observations, statistics::QuantileType quartiles,
                        const std::string& name);

}  // namespace ikbench::figures
