// Chooses the line style of style.gp that a solver has: its colour in every figure, and a line type that tells it from
// others of that colour.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "results/figure_style.hpp"

namespace ikbench::figures {

struct NamedSolver {
  std::string label, algorithm;
};

// The line styles of all solvers of a report, by label. A solver has the colour of style.colours, or else, if it is
// built in, its own of the palette; each other algorithm gets the colour that fewest have. From a palette of fewer than
// seven all get them in order. Solvers of one colour, such as two variants of one algorithm, have different markers and
// dashes. Colours of style.colours that the palette lacks are added to it.
std::map<std::string, int> line_styles(const std::vector<NamedSolver>& solvers, results::FigureStyle& style);

}  // namespace ikbench::figures
