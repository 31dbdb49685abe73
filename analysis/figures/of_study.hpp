// The figures of a judged study, and the parts that a paper's figures are made of. All runs are in curves and boxes;
// what has one value a point shows the first run of each solver.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/figures/plots.hpp"
#include "analysis/judge/judge.hpp"
#include "results/figure_style.hpp"
#include "results/store.hpp"
#include "robots/robot.hpp"

namespace ikbench::figures {

// What all figures of a report look like.
struct Look {
  results::FigureStyle style;                // with the colours that its solvers were given
  std::map<std::string, int> lines;          // style of each solver, by label
  std::map<std::string, std::string> names;  // its short name
};
Look look_of(std::vector<results::Series> solvers, results::FigureStyle style);
Look look_of(const judge::JudgedStudy& judged, results::FigureStyle style);  // solvers in the order of its table

constexpr std::size_t most_drawn_pairs = 15;  // of more only those of the reference

// Those of figures.inc for which the study has values.
struct KindOfFigure {
  std::string name, meaning;
  std::optional<Figure> (*of)(const judge::JudgedStudy& judged, const Look& look);
};
std::vector<KindOfFigure> kinds_of_figures();
std::vector<Figure> of_study(const judge::JudgedStudy& judged, const Look& look);

// Of a user's file: boxes of each metric that has values, and ranks and differences of the first.
std::vector<Figure> of_file(const std::vector<judge::JudgedMetric>& metrics, const Look& look);

// Of a metric, in the unit that figures have.
About about_of(const judge::StudyResults& study, const judge::Metric& metric, std::string caption);

// The solvers that figures show, in their order.
std::vector<std::string> drawn_solvers(const judge::StudyResults& study, const Look& look);

// Values are drawn times `factor`: 10 for cm in mm.
struct DrawnUnit {
  std::string name;
  double factor = 1;
};
DrawnUnit drawn_unit(const judge::StudyResults& study, std::string_view unit);
// Of the groups of these names, in their order.
std::vector<BoxRow> box_rows(const judge::JudgedMetric& metric, const DrawnUnit& unit,
                             const std::vector<std::string>& shown, const Look& look);
// Error against joint motion; `add_printed` adds what a paper printed.
std::optional<Figure> overview_of(const judge::JudgedStudy& judged, const Look& look,
                                  const std::function<void(Dot&)>& add_printed);
// Of at least three solvers that were compared with one another. None with a control, which leaves pairs of others out.
std::optional<Figure> ranks_of(const judge::JudgedMetric& metric, const DrawnUnit& unit,
                               const std::vector<std::string>& shown, const Look& look);
// Each pair that was tested; of more than 15 those of the first name alone. None where all values are equal.
std::optional<Figure> differences_of(const judge::JudgedMetric& metric, const DrawnUnit& unit,
                                     const std::vector<std::string>& shown, const Look& look);
// Medians of all runs with their quartiles, or means.
enum class Average { median, mean };
std::vector<Line> by_point(const judge::StudyResults& study, std::string_view column, const Look& look,
                           Average average);
// The best error after each iteration, of all solves; those that ended earlier keep their last. Solvers without a trace
// have no row.
std::vector<Line> by_iteration(const judge::StudyResults& study, const Look& look, Average average);
// Of the first solver's first run, with the arm at so many of its points; the caption ends with `more`.
Figure path_of(const judge::StudyResults& study, const Look& look, std::size_t arms, const std::string& more);
// Of the joints that turn. Empty where no answer is known.
JointRows joint_rows(const judge::StudyResults& study, const Look& look);

// The corners of an arm from the base to the tool: the origins of a description's joints, or the ends of the table's
// steps along z and x.
std::vector<Corner> corners_of(const robots::Robot& arm, const Eigen::VectorXd& q);

// The line styles of all solvers of a report, by label. A solver has the colour of style.colours, or else, if it is
// built in and no other has it, its own of the palette; all others, such as variants of an algorithm, get the colour
// that fewest have. From a palette of fewer than seven all get them in order. Solvers of one colour have different
// markers and dashes. Colours of style.colours that the palette lacks are added to it.
std::map<std::string, int> line_styles(const std::vector<results::Series>& solvers, results::FigureStyle& style);

}  // namespace ikbench::figures
