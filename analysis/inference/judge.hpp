// Decides which of two is better. Claims, summary, tables and `ikbench compare` all ask here. The study's plan decides:
// its test, adjustment, significance and margin.
#pragma once

#include <string>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// Test results of a pair: p for "the first is better" and for "the first is worse", each corrected as planned, and
// whether the difference is shown to be within the margin.
struct Tested {
  double p_better = statistics::not_defined;
  double p_worse = statistics::not_defined;
  bool within_margin = false;
};
// Turns test results into the verdict. A found difference takes precedence over "within the margin".
Relation relation_of(const Tested& tested, double significance);

struct Judgement {
  Relation relation = Relation::undefined;
  double p = statistics::not_defined;  // corrected for the pairs that are compared
  Estimate difference = {};            // first - second, or their ratio (Evidence::scale)
  std::string test = {};               // "Games-Howell test"
  bool is_fact = false;                // Contrast::is_fact
  std::string undefined = {};          // why there is no test; empty if there is one
};

// Judges two groups by name. Flawed observations (points of one run, times that are not comparable) get no verdict. A
// mean that is not a number is worse than a number, without a test. Throws std::invalid_argument if a group is missing.
Judgement judge(const Evidence& evidence, std::string_view first, std::string_view second);

// Two groups known by their summaries only. judge() follows the plan as far as summaries allow.
struct MeanPair {
  statistics::GroupSummary first, second;
  Better better = Better::smaller;
};
Judgement judge(const MeanPair& means, const results::AnalysisPlan& plan);

// Judges whether a normally distributed number is above 0 (better) or below 0 (worse).
Judgement judge(double value, double standard_error, const results::AnalysisPlan& plan);

// Returns whether p is below the plan's significance.
bool is_significant(double p, const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
