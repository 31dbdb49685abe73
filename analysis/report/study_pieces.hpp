// The tables and figures of a study that no other is needed for.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

struct StudyPieces {
  std::vector<Table> tables = {};
  std::vector<figures::Figure> figures = {};
  std::string results = "results";  // the table that a terminal shows
  std::string path = "path";        // the figure that stands where nothing moves
};

// Of any study: the tables results, anova-METRIC and status; the figures path, METRIC, METRIC-boxes and joints-LETTER.
// No figures where nothing was solved.
StudyPieces study_pieces(const inference::StudyResults& study);

}  // namespace ikbench::report
