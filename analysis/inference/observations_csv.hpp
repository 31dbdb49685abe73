// Observations from a user's CSV, as pandas, R and spreadsheets write it.
// Every mistake in a file is std::invalid_argument: one sentence with the file, the row and what was expected.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "analysis/inference/observations.hpp"

namespace ikbench::inference {

constexpr std::size_t max_groups = 1000;

enum class Layout {
  one_row_a_value,    // "long": a column of values, a column of groups
  one_column_a_group  // "wide": every column is a group
};
enum class RowsOf { no_block, one_block };  // of the wide layout: whether the values of a row belong together
enum class Replicates { checked, as_given };

// Columns by name; empty where there is none or it is to be found.
struct CsvRequest {
  Layout layout = Layout::one_row_a_value;
  std::string value = {};  // in the wide layout: what the numbers are
  std::string group = {};  // left empty: the column group, solver or algorithm
  std::string block = {};  // what every group was given alike: a problem, a target
  std::string run = {};    // rows of one group (and block) with the same run are averaged
  RowsOf rows = RowsOf::no_block;
  Better better = Better::smaller;
  Replicates replicates = Replicates::checked;
  ValueScale scale = ValueScale::plain;  // log10: the logarithms of the values, which have to be positive
};

// Groups and blocks in the order of their first row; a group without a name is "(empty)". Missing values (NA, NaN,
// empty) are left out and counted in the notes; Inf is a value. The mean of a run's rows, and of a block's runs, is
// taken of whole ones alone: one with fewer values than the fullest of the same block is missing, whether its rows are
// absent or have no value, or else a group that crashes would lose its failures from its means. Without blocks a
// whole run has as many rows as most have, and one with more is refused. Blocks without a value of every group are left
// out and counted, and Observations::flaw says which groups lack any; so it does of runs that other groups have, unless
// a group's runs have names of their own. Rows that repeat a group's run, trial, seed, repetition or replicate are no
// replicates: refused unless they are averaged (`run`) or taken as given, which Observations::flaw then says; so is the
// mean of what is left of a run or a block that is not whole.
Observations read_observations(std::string_view text, std::string_view source, const CsvRequest& request);

}  // namespace ikbench::inference
