// Chooses the metrics that a study's report shows.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/study.hpp"

namespace ikbench::inference {

struct ShownMetrics {
  std::vector<Metric> judged;  // in tables, figures and statistics
  std::vector<Metric> listed;  // as numbers only
  std::string left_out;        // a sentence on metrics that say nothing about this study; empty if all do
};

// A study with a paper shows the metrics of every report. Any other study also shows each metric that differs between
// its runs. A metric that is equal in all runs, up to its rounding, or never defined is left out by name.
ShownMetrics shown_metrics(const StudyResults& study);

}  // namespace ikbench::inference
