// The tables and figures of a single study.
#pragma once

#include <map>
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
  std::string path = "path";        // the figure that replaces the animated view
  // A sentence on what a piece shows, by its name; may be empty.
  std::map<std::string, std::string> seen = {};
};

// Pieces of any study: the tables results, anova-METRIC and status; the figures overview, path, METRIC, METRIC-boxes
// and joints. No figures if nothing was solved.
StudyPieces study_pieces(const inference::StudyResults& study);

}  // namespace ikbench::report
