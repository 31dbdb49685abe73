// Decides which of two is better. Claims, summary, tables and `ikbench compare` all ask here. The study's plan decides:
// its test, adjustment, significance and margin.
#pragma once

#include <string>
#include <string_view>

#include "analysis/inference/evidence.hpp"

namespace ikbench::inference {

// The verdict by the p, corrected as planned, for the group that is ahead (1: the first, -1: the second). A found
// difference takes precedence over "within the margin".
Relation relation_of(int ahead, double p, double significance, bool is_within_margin = false);

// Judges two groups by name. Flawed observations (points of one run, times that are not comparable) get no verdict. A
// mean that is not a number is worse than a number, without a test. Throws std::invalid_argument if a group is missing.
Finding judge(const Evidence& evidence, std::string_view first, std::string_view second);

// Judges two groups known by their summaries only. Follows the plan as far as summaries allow.
Finding judge(const statistics::GroupSummary& first, const statistics::GroupSummary& second, Better better,
              const results::AnalysisPlan& plan);

// Judges whether a normally distributed number is above 0 (better) or below 0 (worse).
Finding judge(double value, double standard_error, const results::AnalysisPlan& plan);

// Returns whether p is below the plan's significance.
bool is_significant(double p, const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
