// Curves that rise in stairs from 0 to 1: distribution functions and performance profiles, one a solver.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/convergence.hpp"
#include "analysis/figure.hpp"
#include "analysis/study.hpp"

namespace ikbench {

// What the curve of each solver goes over, and how the axis below shows it.
struct ShareCurves {
  std::vector<std::vector<Share>> curves;  // of the solvers; empty where there is nothing to show
  std::string label;                       // of the axis below
  std::string share_of;                    // of the axis at the left
  bool is_ratio = false;                   // to a smallest, from 1 on, in powers of 2; else powers of 10
};

// Settings, data and plot of the figure, of which the name and width must stand. Values of zero are drawn at the left
// edge.
void draw_shares(Figure& figure, const StudyResults& study, const ShareCurves& shares);

// A logarithmic axis below, and left_edge for what lies before it. Ticks at powers of ten, or between them too where
// there are few.
std::string horizontal_axis(double smallest, double largest);

// A solver without a curve stands in the legend all the same.
std::string legend_entry(std::size_t solver, const std::string& name);

}  // namespace ikbench
