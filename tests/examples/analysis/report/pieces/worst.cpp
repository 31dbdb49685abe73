// The worst solve of each solver: an example of docs/adding-anything.md.
#include <algorithm>

#include "analysis/report/study_pieces.hpp"

namespace ikbench::report {

using namespace inference;

std::vector<Table> worst_tables(const StudyResults& study, const ShownMetrics&) {
  Table table{.name = "worst",
              .caption = "The solve with the largest error",
              .columns = {"algorithm", "run", "point", "position_error_cm"}};
  for (const std::string& solver : study.solvers) {
    const auto solves = solves_of(study, solver);
    const auto worst = std::ranges::max_element(solves, {}, &Solve::position_error_cm);
    if (worst == solves.end()) continue;
    table.rows.push_back({solver, std::int64_t{worst->run}, std::int64_t{worst->point}, worst->position_error_cm});
  }
  return {table};
}

}  // namespace ikbench::report
