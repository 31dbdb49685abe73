// The means of a study's compared metrics, for programs that chart benchmarks over commits.
#pragma once

#include <string>

#include "analysis/inference/judged_study.hpp"

namespace ikbench::report {

// For github-action-benchmark, `customSmallerIsBetter`: an array of name, unit, value, range. A share of solved solves
// becomes that of failed ones, so that smaller is better everywhere.
std::string benchmark_json(const inference::JudgedStudy& study);

// In the Bencher Metric Format (https://bencher.dev/bmf.json): labels, measures, values with their interval.
std::string bencher_json(const inference::JudgedStudy& study);

}  // namespace ikbench::report
