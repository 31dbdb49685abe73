// The error of every solve against its evaluations: an example of docs/adding-anything.md.
#include <fmt/format.h>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/report/study_pieces.hpp"

namespace ikbench::report {

using namespace inference;
using namespace figures;

std::vector<Figure> effort_figures(const StudyResults& all, const ShownMetrics&) {
  const StudyResults study = drawn_part(all);
  Figure figure{.name = "effort", .caption = "Error of every solve against its evaluations, on logarithmic axes."};
  figure.settings = "set logscale xy\nset xlabel 'evaluations'\nset ylabel 'position error [cm]'\n";
  std::vector<std::string> clauses;
  for (const std::string& solver : study.solvers) {
    figure.data += "# evaluations and error [cm] of " + one_line(solver) + '\n';
    for (const Solve& solve : solves_of(study, solver))
      figure.data += fmt::format("{} {}\n", solve.evaluations, data_number(solve.position_error_cm));
    figure.data += "\n\n";  // ends a block, which gnuplot counts from 0
    clauses.push_back(fmt::format("'{}.dat' index {} with points ls {} title {}", figure.name, clauses.size(),
                                  style_of(study, solver), gnuplot_string(shortened(solver, longest_label))));
  }
  figure.plot = plot_command(clauses);
  add_legend(figure, study.solvers);
  return {figure};
}

}  // namespace ikbench::report
