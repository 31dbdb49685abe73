// What the statistics of one quantity say, and show: sentences, tables, figures and JSON, in the order that
// docs/reading-a-report.md explains: what was compared, assumptions, the paper's analysis, the robust one, who differs
// from whom, where methods disagree, and what this does not show.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/judged_study.hpp"
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
// Of a study, by what its plan finds. Times that are not comparable are shown, and not ranked, tested or compared.
Assessment assess(const inference::JudgedStudy& study, inference::Metric metric, results::Estimand estimand);

}  // namespace ikbench::report
