// Is one better than the other? Whatever says so - claims, summary, tables, `ikbench compare` - asks here. What decides
// is the plan of the study: its test, adjustment, significance and margin.
#pragma once

#include <string>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// What tests say of two: p of the first being better and of being worse, each corrected as planned, and whether the
// difference is shown to be within the margin.
struct Tested {
  double p_better = statistics::not_defined;
  double p_worse = statistics::not_defined;
  bool within_margin = false;
};
// The one rule. A difference that is found counts before one that is too small to matter.
Relation relation_of(const Tested& tested, double significance);

struct Judgement {
  Relation relation = Relation::undefined;
  double p = statistics::not_defined;  // corrected for the pairs that are compared
  Estimate difference = {};            // first - second, or their ratio (Evidence::scale)
  std::string test = {};               // "Games-Howell test"
  bool is_fact = false;                // Contrast::is_fact
  std::string undefined = {};          // why there is no test; empty where there is one
};

// Two groups of an evidence, by name. Flawed observations (points of one run, times that are not comparable) have no
// answer. A mean that is not a number is worse than one that is, without a test. std::invalid_argument where a group is
// not there.
Judgement judge(const Evidence& evidence, std::string_view first, std::string_view second);

// Two means of which only the summaries are known, by what of the plan these allow.
struct MeanPair {
  statistics::GroupSummary first, second;
  Better better = Better::smaller;
};
Judgement judge(const MeanPair& means, const results::AnalysisPlan& plan);

// Whether a number with that standard error is above 0 (better) or below, where it is as good as normal.
Judgement judge(double value, double standard_error, const results::AnalysisPlan& plan);

// Whether p refutes that all are alike.
bool is_significant(double p, const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
