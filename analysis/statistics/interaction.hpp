// Tests whether the effect of one factor depends on the other: F of the interaction in a table of two factors, every
// combination observed. Degrees of freedom are lessened for variances that differ (Box, Annals of Mathematical
// Statistics 25 (1954) 290; Brunner, Dette and Munk, J. American Statistical Association 92 (1997) 1494); within blocks
// also for correlations (Greenhouse and Geisser, Psychometrika 24 (1959) 95).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// Independent cells, or values[i] of every cell belong to block i.
enum class Cells { independent, in_blocks };

struct Interaction : Test {  // the statistic is F
  // The effect of the first factor, last level less first, at the last level of the second less at its first: 0 if the
  // effects add. With its interval (Welch and Satterthwaite; within blocks Student).
  Estimate corners = {};
};

// The cells by rows: the levels of the second factor within those of the first. Throws std::invalid_argument if they
// are no rows of `columns`, if blocks differ in number, or if `level` is not between 0 and 1.
Interaction interaction(std::span<const std::vector<double>> cells, std::size_t columns, Cells are, double level);

}  // namespace ikbench::statistics
