// The tables and figures of a single study.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/report_content.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// A line of study_pieces.inc, for studies without a paper. Its function makes tables or figures; figures only if
// anything was solved.
struct StudyPiece {
  std::string_view name, heading;
  bool is_shown;  // else folded
  std::vector<Table> (*tables)(const inference::StudyResults&, const std::vector<inference::Metric>&) = nullptr;
  std::vector<figures::Figure> (*figures)(const inference::StudyResults&,
                                          const std::vector<inference::Metric>&) = nullptr;
};

struct StudyPieces {
  std::vector<Table> tables = {};
  std::vector<figures::Figure> figures = {};
  std::vector<SectionPlan> sections = {};  // places them; empty: the paper does
  std::string results = "results";         // the table that a terminal shows
  std::string path = "path";               // the figure that replaces the animated view
  // A sentence on what a piece shows, by its name; may be empty.
  std::map<std::string, std::string> seen = {};
};

// The pieces of a study without a paper; a paper may extend them.
StudyPieces study_pieces(const inference::StudyResults& study);

}  // namespace ikbench::report
