// The quantities that are judged, of a solve or of a whole run: the table of metrics.inc.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/observations.hpp"
#include "analysis/inference/solve.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

// Index of a row of the table. Only rows that code refers to have a name.
enum class Metric : std::size_t {
  position_error_cm,
  variation_deg,
  seconds,
  evaluations,
  solved,
  orientation_error_deg,
  variation_m
};

// count: how often a solver does something. time: compared only if times are comparable. share: of things that can
// fail; no failure so far proves nothing.
enum class Kind { number, count, time, share };

// everywhere: in every report and comparison. in_comparisons: by `ikbench compare` only. where_it_tells: in reports of
// studies without a paper if it differs between runs (shown_metrics), and in comparisons that name it. if_named: only
// in comparisons and claims that name it.
enum class ShownIn { everywhere, in_comparisons, where_it_tells, if_named };

struct StudyResults;
// The solves of one observation, a run or a target, in the order of their points.
using Run = std::span<const Solve* const>;

struct MetricInfo {
  std::string_view column;  // name in records, in tables and on the command line
  std::string_view slug;    // short name for files and anchors
  std::string_view name;    // name in text
  std::string_view unit;    // empty if there is none
  Better better;
  Kind kind;
  double rounding;  // values up to this size count as zero
  ShownIn shown;
  double (*value)(const Solve& solve, const StudyResults& study);  // null: only a run has a value
  double (*of_run)(Run run, const StudyResults& study);            // null: a run's value is the average over its solves
};

// Throws std::out_of_range for an invalid index.
const MetricInfo& info_of(Metric metric);
std::string_view name_of(Metric metric);  // the column's name
NameWithUnit with_unit(Metric metric);
std::string quantity(Metric metric);  // "position error [cm]"
bool is_of_run(Metric metric);        // true: a single solve has no value
bool is_error(Metric metric);         // true: a distance of an answer from its target
bool is_cost(Metric metric);  // true: the effort for an answer; a solver that does nothing has the least. if_named:
                              // taken as it is
// The metric's value of a solve, or of one observation. Not defined if the metric has no meaning in the study.
double value_of(const StudyResults& study, const Solve& solve, Metric metric);
double value_of(const StudyResults& study, Run run, Metric metric);

// Throws std::invalid_argument if no row has this column.
Metric metric_named(std::string_view column);
// All rows, in the order of the table.
std::vector<Metric> all_metrics();
// Metrics of every report.
std::vector<Metric> reported_metrics();
// Default metrics of `ikbench compare`: first those that do not depend on the machine, then times, then shares.
std::vector<Metric> compared_metrics();

// The metrics of a study's report. A study with a paper has those of every report. Any other study also has each metric
// that differs between its runs.
std::vector<Metric> shown_metrics(const StudyResults& study);

}  // namespace ikbench::inference
