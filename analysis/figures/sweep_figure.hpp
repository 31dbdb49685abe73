// A quantity over a swept setting, with intervals.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/sweep.hpp"

namespace ikbench::figures {

// Families that were swept by the same settings, in one figure: the setting with most numbers along the axis, a curve
// for each family and each combination of the other settings. Several families have a colour each.
Figure sweep_figure(const std::vector<inference::SweptFamily>& families, const inference::SweptQuantity& quantity,
                    const std::string& name);

}  // namespace ikbench::figures
