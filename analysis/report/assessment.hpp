// What the statistics of one quantity say, and show: sentences, tables, figures and JSON, in the order that
// docs/statistics.md explains: what was compared, assumptions, the paper's analysis, the robust one, who differs from
// whom, where methods disagree, and what this does not show.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/evidence.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

struct Assessment {
  std::string name;                        // of Observations; tables and figures are "statistics-<name>-..."
  std::string heading;                     // "Statistics: position error [cm]"
  std::vector<std::string> sentences;      // plain text, each with its topic in front: "Assumptions: ..."
  std::vector<std::string> headlines;      // those that a summary takes
  std::vector<std::string> warnings = {};  // why it must not be taken at its word
  std::vector<Table> tables;
  std::vector<figures::Figure> figures;
  std::string json;  // one object with every number
};

Assessment assess(const inference::Observations& observations, const results::AnalysisPlan& plan);
Assessment assess(const inference::Summaries& summaries, const results::AnalysisPlan& plan);
// What was observed, and no verdict on it: nothing is ranked, tested or compared. The observations' flaw is the reason.
Assessment describe(const inference::Observations& observations, const results::AnalysisPlan& plan);

}  // namespace ikbench::report
