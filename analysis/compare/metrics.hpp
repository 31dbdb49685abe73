// The quantities that are judged: the table of metrics.inc.
#pragma once

#include <span>
#include <string_view>

#include "analysis/compare/observations.hpp"

namespace ikbench::compare {

struct Solve;
struct StudyResults;
using Run = std::span<const Solve>;  // the solves of one run, by point

// share: solved or not. error: a distance from the target. cost: effort for an answer; with a tolerance, only of
// targets that both solvers of a pair solved. time: a cost that is compared only where times are comparable.
enum class Kind { share, error, cost, time };

struct Metric {
  std::string_view column;  // name in files and on the command line
  std::string_view slug;    // of files and anchors
  std::string_view name;    // in text
  std::string_view unit;    // of its values; empty: none
  Kind kind;
  Scale scale;
  double floor;      // of ratios: a smaller value counts as this
  double rounding;   // values that differ by no more are equal
  bool is_reported;  // in every report; else only where a claim or a command names it
  double (*value)(const Solve& solve, const StudyResults& study);  // NaN: the solve has none
  double (*of_run)(Run run);                                       // in place of value
};

std::span<const Metric> metrics();
// Throws std::invalid_argument, which lists all, if no row has this column.
const Metric& metric_named(std::string_view column);

}  // namespace ikbench::compare
