// What the statistics of one quantity say, and show: sentences, tables, figures and JSON, in the order that
// docs/statistics.md explains: what was compared, assumptions, the paper's analysis, the sound one, who differs from
// whom, where methods disagree, and what this does not show.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/evidence.hpp"
#include "analysis/figure.hpp"
#include "analysis/table.hpp"

namespace ikbench {

struct Assessment {
  std::string name;                        // of Observations; tables and figures are "statistics-<name>-..."
  std::string heading;                     // "Statistics: position error [cm]"
  std::vector<std::string> sentences;      // plain text, each with its topic in front: "Assumptions: ..."
  std::vector<std::string> headlines;      // those that a summary takes
  std::vector<std::string> warnings = {};  // why it must not be taken at its word
  std::vector<Table> tables;
  std::vector<Figure> figures;
  std::string json;  // one object with every number
};

Assessment assess(const Observations& observations, const AnalysisPlan& plan);
Assessment assess(const Summaries& summaries, const AnalysisPlan& plan);
// What was observed, and no verdict on it: nothing is ranked, tested or compared. The observations' flaw is the reason.
Assessment describe(const Observations& observations, const AnalysisPlan& plan);

std::vector<std::string> sentences_of(const Evidence& evidence);
std::vector<std::string> headlines_of(const Evidence& evidence);
std::vector<Table> tables_of(const Evidence& evidence);
std::string json_of(const Evidence& evidence);

}  // namespace ikbench
