// What the rules for claims have in common: our numbers beside the printed, whose numbers a claim is about, and what of
// several comparisons follows for it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/slim2023/claim_entries.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

// The claim as it is declared, for a rule to judge.
report::Claim begun(const ClaimEntry& entry);

// A solver with observations here and a printed row.
struct Pair {
  std::string solver;
  statistics::Description ours;
  statistics::GroupSummary printed;
};

// In the printed order, the smallest first.
std::vector<Pair> pairs(const inference::StudyResults& study, inference::Metric metric);

// What the paper printed of those solvers, judged by what of the plan means and standard deviations allow.
inference::Evidence printed_evidence(const std::vector<Pair>& pairs, const results::AnalysisPlan& plan);

// The companion that a claim names, where the report has it and its targets are those of the study.
const inference::JudgedStudy* companion_of(const report::Reported& reported, const ClaimEntry& entry);

// Of the solvers that a claim is about, each from the study that it says; none where one of them has no observations.
std::optional<inference::Evidence> evidence_for(const report::Reported& reported, const ClaimEntry& entry,
                                                inference::Metric metric);

// What was found of one against others, one by one.
struct Found {
  int better = 0, worse = 0, open = 0;

  void add(inference::Relation answer);
  int all() const { return better + worse + open; }
};
// Against all it holds, against some and none the better in part.
report::Verdict verdict_on(const Found& found);
// Of several questions: all hold, some, none.
report::Verdict verdict_on(const std::vector<report::Verdict>& verdicts);

// The solver against each other group of an evidence. Where it should be the largest, the others are better.
enum class Should { be_smallest, be_largest };
struct Against {
  Found found;
  double p = statistics::not_defined;  // the largest
  std::string nearest = {};            // of the others, by the mean
  double own_mean = statistics::not_defined, nearest_mean = statistics::not_defined;
};
Against against(const inference::Evidence& evidence, const std::string& solver, Should should = Should::be_smallest);

// " (p = 0.01)"
std::string in_brackets(double p);
std::string how_tested(const inference::Evidence& here, const inference::Evidence& printed);

}  // namespace ikbench::slim2023
