// A claim before its verdict: its entry and the report's numbers for it; and the verdict that follows from several
// comparisons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/claims/claims_file.hpp"
#include "analysis/claims/printed.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::claims {

using Claims = std::vector<report::Claim>;

// A solver with observations here and a printed row.
struct Pair {
  std::string solver;
  statistics::Description ours;
  statistics::GroupSummary printed;
};

struct Case {
  const ClaimsFile& file;
  const ClaimEntry& entry;
  const report::Reported& reported;

  const inference::JudgedStudy& study() const { return reported.study; }
  // The claim, still undecided.
  report::Claim begun() const;
  // Returns whether the paper's means are about this study, or if the paper prints no means.
  bool is_of_means() const;
  // The pairs in the printed order, the smallest first; those of the claim's two solvers, if it is about two.
  std::vector<Pair> pairs(inference::Metric metric) const;
  // Returns whether the study has the claim's solver and another one whose means are printed.
  bool is_printed() const;
  // Returns whether it has both, among the printed ones if the paper prints means.
  bool has_solver() const;
  // The paper's numbers of those solvers, judged by the plan as far as means and standard deviations allow.
  inference::Evidence printed_evidence(const std::vector<Pair>& pairs) const;
  // The companion that the claim names, if the report has it and its targets are those of the study.
  const inference::JudgedStudy* companion() const;
  // Evidence on the claim's solvers and others, each from its study; nothing if one of them has no observations.
  std::optional<inference::Evidence> evidence(inference::Metric metric) const;
};

// The printed rows that are comparable with a study; none on a path that they are not about.
std::vector<PrintedRow> printed_rows(const ClaimsFile& file, const inference::StudyResults& study,
                                     inference::Metric metric);

// The same as summaries of at least two solvers, which the report assesses by its own methods.
std::vector<inference::Observations> printed_summaries(const ClaimsFile& file, const inference::StudyResults& study);

// Counts of one solver's comparisons with others.
struct PairCounts {
  int better = 0, worse = 0, open = 0;

  void add(inference::Relation relation);
  int all() const { return better + worse + open; }
};
// Holds if better than all, fails if worse than one; in between it holds in part if better than some.
report::Verdict verdict_on(const PairCounts& found);
// The verdict on several questions: all hold, some, or none.
report::Verdict verdict_on(const std::vector<report::Verdict>& verdicts);
// Holds or fails, and holds in part if it is so on average only.
report::Verdict verdict_of(bool always, bool on_average = false);

std::string in_brackets(double p);                              // " (p = 0.01)"
std::string title(inference::Metric metric);                    // "Position error"
std::string number_of(double value, inference::Metric metric);  // all times are in ms
std::string with_unit(double value, inference::Metric metric);  // "0.0017 cm"

}  // namespace ikbench::claims
