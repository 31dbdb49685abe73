// A claim on the way to its verdict: its entry and the numbers that a report has for it; and what of several
// comparisons follows for a claim.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/claims/claims_file.hpp"
#include "analysis/claims/printed.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/statistics/anova.hpp"

namespace ikbench::claims {

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
  // Undecided so far.
  report::Claim begun() const;
  // Whether the study is one that the paper's means are about; any is where it prints none.
  bool is_of_means() const;
  // In the printed order, the smallest first.
  std::vector<Pair> pairs(inference::Metric metric) const;
  // Whether the study has the claim's solver, and another, of what is printed where anything is.
  bool has_solver() const;
  // What the paper printed of those solvers, judged by what of the plan means and standard deviations allow.
  inference::Evidence printed_evidence(const std::vector<Pair>& pairs) const;
  // The companion that the claim names, where the report has it and its targets are those of the study.
  const inference::JudgedStudy* companion() const;
  // Of the solvers that the claim is about, each from the study that it says; none where one of them has no
  // observations.
  std::optional<inference::Evidence> evidence(inference::Metric metric) const;
};

// The printed rows that a study can be held against; none on a path that they are not about.
std::vector<PrintedRow> printed_rows(const ClaimsFile& file, const inference::StudyResults& study,
                                     inference::Metric metric);

// The same as summaries, which the report assesses by its own methods: those of two solvers at least.
std::vector<inference::Summaries> printed_summaries(const ClaimsFile& file, const inference::StudyResults& study);
// The printed ANOVA of that metric where it answers the same question: the same solvers, runs as observations.
std::optional<statistics::AnovaTable> printed_anova(const ClaimsFile& file, const inference::StudyResults& study,
                                                    inference::Metric metric);

// What was found of one against others, one by one.
struct Found {
  int better = 0, worse = 0, open = 0;

  void add(inference::Relation relation);
  int all() const { return better + worse + open; }
};
// Against all it holds, against some and none the better in part.
report::Verdict verdict_on(const Found& found);
// Of several questions: all hold, some, none.
report::Verdict verdict_on(const std::vector<report::Verdict>& verdicts);

// A solver against each other group of an evidence. Where it should be the largest, the others are better.
enum class Should { be_smallest, be_largest };
struct Against {
  Found found = {};
  std::string nearest = {};  // of the others, by the mean
  double own_mean = statistics::not_defined, nearest_mean = statistics::not_defined;
};
Against against(const inference::Evidence& evidence, const std::string& solver, Should should = Should::be_smallest);

std::string in_brackets(double p);  // " (p = 0.01)"
std::string with_unit(double value, std::string_view unit);
// "IK-BA 0.0017 cm, K-ABC 0.208 (p = 0.001), DE 0.253 (p = 0.002)", the others by their means.
std::string list_of(const inference::Evidence& evidence, const std::string& solver, std::string_view unit);
std::string how_tested(const inference::Evidence& here, const inference::Evidence& printed);

}  // namespace ikbench::claims
