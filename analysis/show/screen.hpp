// The last screen of `run`, `report`, `compare` and `stats`.
#pragma once

#include <string>

#include "analysis/show/shown.hpp"

namespace ikbench::show {

constexpr std::size_t screen_lines = 20;

// At most so many lines: the headline, pairs, the table of results, warnings; where `page` is, if it is not empty.
// Pairs are those of the metric of the headline; where there are only two groups, those of every metric.
std::string screen(const Shown& shown, const std::string& page = {});

}  // namespace ikbench::show
