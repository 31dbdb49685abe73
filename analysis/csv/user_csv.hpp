// A user's CSV as observations: long (a column of labels, one of values) or wide (a column of values for each group).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/compare/compare.hpp"
#include "analysis/compare/observe.hpp"

namespace ikbench::csv {

constexpr std::size_t most_groups = 100;

// Columns by name; what is empty is found, or is not there.
struct Request {
  std::vector<std::string> values = {};  // each a quantity; found: the only column of numbers
  std::string label = {};                // found: solver, algorithm, group, label, method or name, else the text
  std::string block = {};                // target, problem or run that all groups had: makes observations paired
  std::string run = {};                  // rows of a run (of a block) are averaged: they are no replicates
  std::vector<std::string> where = {};   // "metric=error": takes these rows alone
  bool is_larger_better = false;         // of numbers; of shares (all values 0 or 1) it always is
  char separator = 0, decimal = 0;       // 0: found
};

struct Quantities {
  std::vector<compare::Observations> observed;
  std::vector<std::string> notes = {};  // what the values settled, as sentences; they stand below the table of results
};

// Without labels every column of numbers is a group, but runs and numbers of rows. Rows without a label are left out
// and counted. A value that is missing or infinite is lost, and so is a mean of fewer rows than others have. Values are
// compared by ratios, 0 as the smallest value above it; by differences if one is negative. A file of solves (`ikbench
// export`) has the metrics of a report, if all is in the file that they need. Throws std::invalid_argument, as Sheet
// does.
Quantities read(std::string_view text, std::string_view source, const Request& request);

// Columns name (or as above), n, mean, sd (or std), and metric where there are several quantities. Of the request,
// where, is_larger_better, separator and decimal count.
Quantities read_summaries(std::string_view text, std::string_view source, const Request& request);

// The plan with a margin, "5%"; or "0.1" in the unit of the values, which becomes theirs. Empty: the plan's, but none
// of values that may be negative, of which a share means nothing.
compare::Plan with_margin(compare::Plan plan, const std::string& margin, compare::Observations& of);

}  // namespace ikbench::csv
