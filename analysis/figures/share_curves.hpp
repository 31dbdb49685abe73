// Curves over a logarithmic axis of costs, one a solver; those in stairs between 0 and 1: distribution functions
// and performance profiles.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

constexpr std::size_t most_bands = 6;  // more lie on top of each other

// The axis below; what lies outside is drawn at its edges.
struct CostAxis {
  double left = 1;
  double right = 10;
  std::string settings = {};  // range, ticks and the function shown_x(x): where x is drawn
};
// Logarithmic, or linear where the largest is less than four times the smallest. No ticks where they are no positive
// numbers.
CostAxis cost_axis(double smallest, double largest);
// From 1 on, in powers of 2.
CostAxis ratio_axis(double largest);

// A curve in the data file of a figure.
struct DrawnCurve {
  std::string source;      // "'NAME.dat' index 0 using 1:2"
  std::size_t rows = 0;    // of the data
  std::size_t solver = 0;  // from 0: its colour, dashes and marker, and where the markers begin
  std::string label = {};  // of the solver
};
// A line with nine markers or so, which do not begin where those of the next solver do.
void add_curve(std::vector<std::string>& clauses, const DrawnCurve& curve);
// In the legend all the same; the entry as it stands there.
std::string add_missing_curve(std::vector<std::string>& clauses, std::size_t solver, const std::string& label);

// What the curve of each solver goes over, and what the axes say.
struct ShareCurves {
  std::vector<std::vector<inference::Share>> curves;  // of the solvers; empty where there is nothing to show
  std::string label;                                  // of the axis below
  std::string share_of;                               // of the axis at the left
  bool is_ratio = false;                              // to a smallest: from 1 on
};
// Settings, data and plot of the figure, of which the name and width must stand. Intervals of shares are drawn as bands
// behind the curves where there are at most most_bands solvers, and stand in the data file in any case.
void draw_shares(Figure& figure, const inference::StudyResults& study, const ShareCurves& shares);

}  // namespace ikbench::figures
