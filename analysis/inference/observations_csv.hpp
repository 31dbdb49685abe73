// Reads observations from a user's CSV, as pandas, R and spreadsheets
// write it. Every mistake in a file throws std::invalid_argument: one sentence with the file, the row and what was
// expected.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/inference/observations.hpp"

namespace ikbench::inference {

constexpr std::size_t max_groups = 1000;

// Columns by name; empty if there is none or it is to be found.
struct CsvRequest {
  bool is_wide = false;          // every column is a group; else a column of values and one of groups ("long")
  std::string value = {};        // wide layout: names the quantity
  std::string group = {};        // left empty: the column group, solver or algorithm
  std::string block = {};        // problem or target that every group was given
  std::string run = {};          // rows of one group (and block) with the same run are averaged
  bool rows_are_blocks = false;  // wide layout: the values of a row form a block
  Better better = Better::smaller;
  bool takes_any_rows = false;           // accepts rows that are no replicates, and incomplete runs
  ValueScale scale = ValueScale::plain;  // log10: takes logarithms of the values, which must be positive
};

// Groups and blocks keep the order of their first row; a group without a name is "(empty)". Missing values (NA, NaN,
// empty) are left out and counted in the notes; Inf is a value. Only whole runs and blocks are averaged: one with fewer
// values than the fullest of the same block counts as missing, or else a group that crashes would lose its failures
// from its means. Without blocks a whole run has as many rows as most runs have, and a run with more is refused. Blocks
// that lack a group's value are left out and counted, and Observations::flaws names the groups; likewise for runs that
// other groups have, unless a group's runs have their own names. Rows that repeat a group's run, trial, seed,
// repetition or replicate are no replicates. They are refused unless they are averaged (`run`) or taken as given, which
// Observations::flaws then says; so are means over incomplete runs or blocks.
Observations read_observations(std::string_view text, std::string_view source, const CsvRequest& request);

}  // namespace ikbench::inference
