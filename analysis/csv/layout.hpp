// What the columns of a user's CSV are, by what they hold. What can be read in two ways is asked.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/sheet.hpp"

namespace ikbench::csv {

using base::Sheet, base::in_quotes, base::listed;

constexpr std::size_t most_groups = 100;

using Column = std::optional<std::size_t>;
using Columns = std::vector<std::size_t>;

// Columns by name; what is empty is found, or is not there. Every file has a column `row`, of the number of each row.
struct Request {
  std::vector<std::string> values = {};  // each a quantity; found: the only column of numbers
                                         // or, without labels, groups
  std::vector<std::string> label = {};   // found: the only column of text
  std::vector<std::string> block = {};   // target or problem that all groups had: makes observations paired
  std::string run = {};                  // rows of a run (of a block) are averaged: they are no replicates
  std::vector<std::string> where = {};   // "metric=error": takes these rows alone
  std::vector<std::string> better = {};  // "smaller" or "larger", of one column "quality=larger"; else smaller
  char decimal = 0;                      // mark of decimals; 0: found
  bool are_summaries = false;            // rows have printed means and standard deviations
};

// Where things are. Without a label each column of values is a group.
struct Layout {
  Column label, block, run;  // a run has several rows
  Columns values;
  Columns counting;  // columns that number the rows, and are left out
};

using Options = std::vector<std::string>;  // "--run", "seed"
Request with(Request request, const Options& options);

// The file can be read in several ways: what is open, and the options to add for the likely ones, the likeliest first.
struct Question : std::invalid_argument {
  Question(const std::string& what, std::vector<Options> ways) : invalid_argument(what), answers(std::move(ways)) {}
  std::vector<Options> answers;
};

// A number, and half of its last digit.
struct Printed {
  double value, half;
};
Printed printed(Sheet& sheet, std::size_t row, std::size_t column);
// How far values follow those before them, in standard deviations of what any order would give: by von Neumann's ratio
// of ranks (Bartels, JASA 77 (1982) 40), of all lists together.
double following(const std::vector<std::vector<double>>& lists);
// Whether the last number of each list is to its last digit one statistic of the others, and not by chance: mean, sum,
// median, geometric mean, smallest, largest, standard deviation; of two also a difference or ratio; or of the numbers
// `of` in place of the others, as of their ranks, only the mean, 0, or the sum, 1. `tried`: of how many such lists of a
// file these are.
using Lists = std::vector<std::vector<Printed>>;
bool are_computed(const Lists& lists, double tried, const Lists& of = {}, std::size_t one = 0);

// Rows without a label count for nothing. Throws a Question, or std::invalid_argument as Sheet does.
Layout layout_of(Sheet& sheet, const Request& request);

}  // namespace ikbench::csv
