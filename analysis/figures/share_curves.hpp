// Curves over a logarithmic axis of costs, one per solver; stairs between 0 and 1: distribution functions and
// performance profiles.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

constexpr std::size_t most_bands = 6;  // more would cover each other

// A curve in the data file of a figure.
struct DrawnCurve {
  std::string source;      // "'NAME.dat' index 0 using 1:2"
  std::size_t rows = 0;    // rows of the data
  std::size_t solver = 0;  // from 0: decides colour, dashes, marker, and the first marker's place
  std::string label = {};  // the solver's label
};
// Adds a line with about nine markers, which begin elsewhere than the next solver's.
void add_curve(std::vector<std::string>& clauses, const DrawnCurve& curve);
// Adds a solver without a curve to the legend; returns its entry.
std::string add_missing_curve(std::vector<std::string>& clauses, std::size_t solver, const std::string& label);

// The curves of the solvers, and the labels of the axes.
struct ShareCurves {
  std::vector<std::vector<inference::Share>> curves;  // one per solver; empty if there is nothing to show
  std::string label;                                  // label of the axis below
  std::string share_of;                               // label of the axis at the left
};
// Adds settings, data and plot to a figure, whose name and width must be set. Draws intervals of shares as bands behind
// the curves if there are at most most_bands solvers; the data file always has them.
void draw_shares(Figure& figure, const inference::StudyResults& study, const ShareCurves& shares);

}  // namespace ikbench::figures
