// What is judged of a solve, or of a run as a whole: the table of metrics.inc.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/name_with_unit.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/inference/solve.hpp"

namespace ikbench::inference {

// A row of the table, by its place. Those that some code says something particular of have a name.
enum class Metric : std::size_t {
  position_error_cm,
  variation_deg,
  seconds,
  evaluations,
  solved,
  orientation_error_deg,
  variation_m,
  excess_error_cm
};

// count: how often a solver does something. time: compared only where times are
// comparable. share: of what can fail, so that never having failed is no proof.
enum class Kind { number, count, time, share };

// everywhere: in every report and comparison. in_comparisons: by `ikbench compare` alone. The others in reports of
// studies without a paper, where they differ from run to run (analysis/inference/shown_metrics.hpp), and in comparisons
// that name them: where_it_tells like those shown everywhere, in_tables as numbers alone.
enum class Shown { everywhere, in_comparisons, where_it_tells, in_tables };

struct StudyResults;
// The solves of a run, or of what else is one observation, in the order of their points.
using Run = std::span<const Solve* const>;

struct MetricInfo {
  std::string_view column;  // its name in the record, in tables and on the command line
  std::string_view slug;    // of files and anchors, and where it is clear what it is of
  std::string_view name;    // as it is read
  std::string_view unit;    // empty where there is none
  Better better;
  Kind kind;
  double rounding;  // up to here a value is none
  Shown shown;
  double (*value)(const Solve& solve, const StudyResults& study);  // null: it is of a run alone
  double (*of_run)(Run run, const StudyResults& study);            // null: a run has the average of its solves' values
};

// std::out_of_range for what is no row.
const MetricInfo& info_of(Metric metric);
std::string_view name_of(Metric metric);  // the column's name
NameWithUnit with_unit(Metric metric);
std::string quantity(Metric metric);  // "position error [cm]"
bool is_of_run(Metric metric);        // alone: a single solve has no value
bool is_error(Metric metric);         // how far an answer is from its target
bool is_cost(Metric metric);          // what an answer takes: a solver that does nothing has the least
// Of a solve, and of what is one observation. Not defined where the metric has no meaning in the study.
double value_of(const StudyResults& study, const Solve& solve, Metric metric);
double value_of(const StudyResults& study, Run run, Metric metric);

// In the order of the table.
std::vector<Metric> all_metrics();
// Of every report, whatever the study.
std::vector<Metric> reported_metrics();
// Of `ikbench compare` where none is named: first what every machine gives alike, then times, then shares.
std::vector<Metric> compared_metrics();

}  // namespace ikbench::inference
