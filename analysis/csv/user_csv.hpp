// A user's CSV as observations: long (a column of labels, one of values) or wide (a column of values for each group).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/csv/layout.hpp"
#include "analysis/judge/statistics/compare_pairs.hpp"

namespace ikbench::csv {

struct Quantities {
  std::vector<judge::MetricSamples> observed;
  std::vector<std::string> notes = {};  // what the values settled, as sentences; they stand below the table of results
};

// Rows without a label are left out and counted. A value that is missing is lost, and so is a mean of fewer rows than
// others have; infinite ones stand for no answer. Values are compared by ratios; by differences if one is 0 or below.
// Throws a Question where the layout or which way is better was not said; else std::invalid_argument, as Sheet does,
// also for a row that sums up others and for a file of solves (`ikbench export`), which lacks what its report knows.
// Summaries have columns n, mean, sd (or as usual), one of names, and metric where there are several quantities; of the
// request, label, n, where, better and decimal count.
Quantities read(std::string_view text, std::string_view source, const Request& request);

// The plan with a margin, "5%"; or "0.1" in the unit of the values, which becomes theirs. Empty: the plan's, but none
// of values that may be negative, of which a share means nothing.
judge::AnalysisPlan with_margin(judge::AnalysisPlan plan, const std::string& margin, judge::MetricSamples& samples);

}  // namespace ikbench::csv
