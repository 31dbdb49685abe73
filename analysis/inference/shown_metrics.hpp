// Which metrics the report of a study shows.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/study.hpp"

namespace ikbench::inference {

struct ShownMetrics {
  std::vector<Metric> judged;  // in tables, figures and statistics
  std::vector<Metric> listed;  // as numbers alone
  std::string left_out;        // what says nothing about this study, in a sentence; empty where all do
};

// Of a study with a paper those of every report. Of another also each metric that differs between its runs; one
// that is the same in all of them, up to the metric's rounding, or not defined in any is left out by name.
ShownMetrics shown_metrics(const StudyResults& study);

}  // namespace ikbench::inference
