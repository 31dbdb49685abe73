// The specification curve of one solver's mean error by that of its best rival.
#pragma once

#include <string>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/multiverse.hpp"

namespace ikbench::claims {

// Draws at most 400 universes, evenly by rank. Pools the runs of all seeds.
figures::Figure error_curve(const inference::Multiverse& multiverse, const std::string& solver);

}  // namespace ikbench::claims
