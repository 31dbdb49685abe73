// What is judged of a solve: the table of metrics.inc.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/observations.hpp"
#include "results/record.hpp"

namespace ikbench::inference {

// A row of the table, by its place. Those that some code says something particular of have a name.
enum class Metric : std::size_t { position_error_cm, variation_deg, seconds, evaluations, solved };

// count: how often a solver does something, which is a fact where it is constant. time: compared only where times are
// comparable. share: of what can fail, so that never having failed is no proof.
enum class Kind { number, count, time, share };

enum class Shown { everywhere, in_comparisons };  // in_comparisons: by `ikbench compare` alone

struct MetricInfo {
  std::string_view column;  // its name in the record, in tables and on the command line
  std::string_view slug;    // of files and anchors, and where it is clear what it is of
  std::string_view name;    // as it is read
  std::string_view unit;    // empty where there is none
  Better better;
  Kind kind;
  double rounding;  // up to here a value is none
  Shown shown;
  double (*value)(const results::SolveRecord& solve);
};

// std::out_of_range for what is no row.
const MetricInfo& info_of(Metric metric);
std::string_view name_of(Metric metric);  // the column's name
std::string quantity(Metric metric);      // "position error [cm]"
double value_of(const results::SolveRecord& solve, Metric metric);

// In the order of the table.
std::vector<Metric> reported_metrics();
// Of `ikbench compare`: first what every machine gives alike, then times, then shares.
std::vector<Metric> compared_metrics();

}  // namespace ikbench::inference
