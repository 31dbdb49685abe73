// The look that all figures of a report share: the style, and each solver's colour, marker and short name. A report
// makes one look and passes the look to all figures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/judge/judge.hpp"
#include "results/figure_style.hpp"
#include "results/store.hpp"

namespace ikbench::figures {

// The look of a report's figures.
struct Look {
  results::FigureStyle style;                // with the colours of the solvers
  std::map<std::string, int> lines;          // style of each solver, by label
  std::map<std::string, std::string> names;  // short name of each solver, by label
  std::vector<std::string> own = {};         // the study's first solver and the control, drawn first of many lines
};
// Returns the look for these solvers.
Look look_of(std::vector<results::Series> solvers, results::FigureStyle style);
// Returns the look for the solvers of a study, in the order of the study's table of results.
Look look_of(const judge::JudgedStudy& judged, results::FigureStyle style);

// Returns the line styles of all solvers of a report, by label. A solver has the colour that style.colours names. A
// built-in solver without such a colour has a colour of the palette for itself, if no other solver has that colour. All
// other solvers, such as variants of an algorithm, get the colour that the fewest solvers have. From a palette of fewer
// than seven colours all solvers get colours in order. Solvers of one colour have different markers and dashes. Colours
// of style.colours that the palette lacks are added to the palette.
std::map<std::string, int> line_styles(const std::vector<results::Series>& solvers, results::FigureStyle& style);

// Returns whether a name means a figure: "error" means error-boxes and error-by-point.
bool is_meant(const std::string& figure, const std::string& name);
// Replaces captions and titles of figures by the words that the style has for them. Returns a sentence for each word of
// the style that no figure uses, with the names of the figures that could use such a word.
std::vector<std::string> reword(const std::vector<Figure*>& figures, const results::FigureStyle& style);

}  // namespace ikbench::figures
