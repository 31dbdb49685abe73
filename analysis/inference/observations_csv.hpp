// Reads a user's CSV, as pandas, R and spreadsheets write it: observations, or published summaries of them. Every
// mistake in a file throws std::invalid_argument: one sentence with the file, the row and what was expected.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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
  bool takes_any_rows = false;           // accepts rows that are no replicates, and averages incomplete runs
  ValueScale scale = ValueScale::plain;  // log10: takes logarithms of the values, which must be positive
};

// Groups and blocks keep the order of their first row; a group without a name is "(empty)". Missing values (NA, NaN,
// empty) are left out; Inf is a value. Only whole runs and blocks are averaged: one with fewer values than the fullest
// (of the same block) counts as missing, or else a group that crashes would lose its failures from its means. A run of
// other groups counts as missing in a group that shares a run with them. Blocks that lack a group's value are left out.
// Observations::flaws counts what is missing by group. Rows that repeat a group's run, trial, seed, repetition or
// replicate are no replicates. They are refused unless they are averaged (`run`) or taken as given, which
// Observations::flaws then says.
Observations read_observations(std::string_view text, std::string_view source, const CsvRequest& request);

// Columns, in any case: name (or group, solver, algorithm), mean, sd (or std, stddev), n (or count); and for several
// quantities metric (or quantity, variable). Returns the summaries of each quantity, in the order of first rows.
std::vector<Observations> read_summaries(std::string_view text, std::string_view source);

}  // namespace ikbench::inference
