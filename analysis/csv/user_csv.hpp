// Reads a user's CSV into samples, for `ikbench stats`. The table is long (a column of labels and one of values) or
// wide (a column of values per group). docs/your-own-csv.md documents both. Tables may have ten million rows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/csv/layout.hpp"
#include "analysis/judge/statistics/compare_pairs.hpp"

namespace ikbench::csv {

// All quantities of a table.
struct Quantities {
  std::vector<judge::MetricSamples> samples;
  std::vector<std::string> notes = {};  // sentences below the table of results: how the table was read
};

// Reads a table. Rows without a label are left out and counted. A cell without a value is a missing value, and so is a
// mean of fewer rows than other groups have. Infinite values stand for no answer. Values are compared by ratios, or by
// differences if a value is 0 or below. Throws MissingOption if the layout is not known, or whether smaller or larger
// is better. Throws std::invalid_argument, as Sheet does, also for a row that sums up others and for a file of solves
// (`ikbench export`), which lacks what the report of the store knows. A table of summaries has columns n, mean, sd (or
// their usual names), one of names, and metric if there are several quantities; only label, n, where, better and
// decimal of the request count.
Quantities read(std::string_view text, std::string_view source, const Request& request);

// Returns the plan with a margin such as "5%". A margin in the unit of the values, such as "0.1", is set in the
// samples. If `margin` is empty, the margin of the plan stays, except that values that may be negative have no margin,
// because a share of such values means nothing. Throws std::invalid_argument if the margin is impossible.
judge::AnalysisPlan with_margin(judge::AnalysisPlan plan, const std::string& margin, judge::MetricSamples& samples);

}  // namespace ikbench::csv
