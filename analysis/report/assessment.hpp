// The statistics of one quantity as sentences, tables, figures and JSON, in the order that docs/reading-a-report.md
// explains.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/report/sentence.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// The pairs of an evidence as a table of data, and how its best group (or the control) relates to the others: undecided
// if one is, else better or worse if it is so of one.
struct Findings {
  Table pairs = {};  // first, second, relation, estimate, low, high, is_ratio, p
  inference::Relation lead = inference::Relation::undefined;
};
Findings findings_of(const inference::Evidence& evidence);

struct Assessment {
  std::string name;      // as in Observations; tables and figures are "statistics-<name>-..."
  std::string quantity;  // "position error [cm]"
  std::string unit = {};
  std::vector<Sentence> sentences;       // plain text
  std::vector<std::string> answer = {};  // its sentences, without full stops
  inference::Doubts flaws = {};          // reasons to doubt it
  Findings findings = {};
  std::vector<Table> tables;
  std::vector<figures::Figure> figures;
  std::string json;  // one object with every number
};

// "Statistics: position error [cm]"
std::string heading_of(const Assessment& assessment);

// Figures show the groups in `drawn`; all if it is empty.
Assessment assess(const inference::Observations& observations, const results::AnalysisPlan& plan,
                  const std::vector<std::string>& drawn = {});
// Assesses a metric of a study by the study's plan. Times that are not comparable are shown, but not ranked, tested or
// compared.
Assessment assess(const inference::JudgedStudy& study, inference::Metric metric, results::Estimand estimand);

// The parts of an assessment. The JSON has all numbers, also those that tables leave out.
std::vector<Sentence> sentences_of(const inference::Evidence& evidence);
std::vector<Table> tables_of(const inference::Evidence& evidence);
std::string json_of(const inference::Evidence& evidence);

}  // namespace ikbench::report
