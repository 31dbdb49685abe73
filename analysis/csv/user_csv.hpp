// A user's CSV as observations: long (a column of labels, one of values) or wide (a column of values for each group).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/compare/compare.hpp"

namespace ikbench::csv {

constexpr std::size_t most_groups = 100;

// Columns by name; what is empty is found, or is not there.
struct Request {
  std::vector<std::string> values = {};  // each a quantity; found: the only column of numbers
                                         // or, without labels, groups
  std::vector<std::string> label = {};   // found: solver, algorithm, group, label, method or name, else the text
  std::vector<std::string> block = {};   // target, problem or run that all groups had: makes observations paired
  std::string run = {};                  // rows of a run (of a block) are averaged: they are no replicates
  std::vector<std::string> where = {};   // "metric=error": takes these rows alone
  std::vector<std::string> better = {};  // "smaller" or "larger", of one column "quality=larger"; else smaller
  char decimal = 0;                      // mark of decimals; 0: found
};

struct Quantities {
  std::vector<compare::Observations> observed;
  std::vector<std::string> notes = {};  // what the values settled, as sentences; they stand below the table of results
};

// Without labels every column of numbers is a group, but runs. Rows without a label are left out and counted. A value
// that is missing is lost, and so is a mean of fewer rows than others have; infinite ones stand for no answer. Values
// are compared by ratios; by differences if one is 0 or below. Throws std::invalid_argument, as Sheet does; also where
// nobody said which way is better of shares and of what is called a success, rate, accuracy, reward or score, and for a
// file of solves (`ikbench export`), which lacks what its report knows.
Quantities read(std::string_view text, std::string_view source, const Request& request);

// Columns name (or as above), n, mean, sd (or as usual), and metric where there are several quantities. Of the request,
// where, better and decimal count.
Quantities read_summaries(std::string_view text, std::string_view source, const Request& request);

// The plan with a margin, "5%"; or "0.1" in the unit of the values, which becomes theirs. Empty: the plan's, but none
// of values that may be negative, of which a share means nothing.
compare::Plan with_margin(compare::Plan plan, const std::string& margin, compare::Observations& observed);

}  // namespace ikbench::csv
