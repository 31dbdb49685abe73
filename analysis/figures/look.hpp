// What all figures of a report look like: its style, and each solver's colour, marker and short name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/judge/judge.hpp"
#include "results/figure_style.hpp"
#include "results/store.hpp"

namespace ikbench::figures {

struct Look {
  results::FigureStyle style;                // with the colours that its solvers were given
  std::map<std::string, int> lines;          // style of each solver, by label
  std::map<std::string, std::string> names;  // its short name
  std::vector<std::string> own = {};         // the study's first solver and its control: of many lines the first
};
Look look_of(std::vector<results::Series> solvers, results::FigureStyle style);
Look look_of(const judge::JudgedStudy& judged, results::FigureStyle style);  // solvers in the order of its table

// The line styles of all solvers of a report, by label. A solver has the colour of style.colours, or else, if it is
// built in and no other has it, its own of the palette; all others, such as variants of an algorithm, get the colour
// that fewest have. From a palette of fewer than seven all get them in order. Solvers of one colour have different
// markers and dashes. Colours of style.colours that the palette lacks are added to it.
std::map<std::string, int> line_styles(const std::vector<results::Series>& solvers, results::FigureStyle& style);

// "error" means error-boxes and error-by-point.
bool is_meant(const std::string& figure, const std::string& name);
// Gives figures the words that the style has for them. Returns a sentence for each that none has, with those that do.
std::vector<std::string> reword(const std::vector<Figure*>& figures, const results::FigureStyle& style);

}  // namespace ikbench::figures
