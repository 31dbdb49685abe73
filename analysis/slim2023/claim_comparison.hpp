// What the claims have in common: our means beside the printed, and whether one is smaller than another.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/slim2023/paper_tables.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

// A solver with observations here and a printed row.
struct Pair {
  std::string solver;
  statistics::Description ours;
  statistics::GroupSummary printed;
};

// In the printed order, the smallest first.
std::vector<Pair> pairs(const inference::StudyResults& study, const std::vector<Comparison>& rows,
                        inference::Metric metric);

// One solver of a study; none where it has no observations.
std::optional<statistics::Description> description(const inference::StudyResults& study, std::string_view solver,
                                                   inference::Metric metric);

// Whether one is smaller than another, since two means always differ.
struct Smaller {
  report::Verdict verdict;
  double p;  // not defined where there is no test
};
Smaller smaller(const inference::Judgement& found);

// What the paper printed of those solvers, judged by what of the plan means and standard deviations allow.
inference::Evidence printed_evidence(const std::vector<Pair>& pairs, const results::AnalysisPlan& plan);

// A claim about several holds as far as it does for the least certain of them.
void weaken(Smaller& claim, const Smaller& by);

// " (p = 0.01)"
std::string in_brackets(double p);
// " (p at most 0.01 against each other solver)"
std::string at_most(double p);
std::string how_tested(const inference::Evidence& here, const inference::Evidence& printed);

}  // namespace ikbench::slim2023
