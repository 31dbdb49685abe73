// A metric by one of its estimands: the value of a solve that goes into an observation, and how to read it. The largest
// values decide a mean over decades, but neither the typical value nor the share within a distance.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/observations.hpp"
#include "analysis/inference/study.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::inference {

constexpr double penalty = 10;

// Describes observations by an estimand, and turns a run into one.
struct Quantity {
  Observations described;        // name, quantity, unit, better, scale and counting, without groups
  std::string average = "mean";  // average of an observation's solves, in words
  OfRun value = {};              // the value of a run
};

// The estimand that averages a metric: the typical value for times, because one interruption would decide a mean; else
// the mean.
results::Estimand average_estimand(Metric metric);

// The plan's estimands of a metric. The position error has all, other metrics only their average; computing time also
// has the reliability if the study has a deadline.
std::vector<results::Estimand> estimands_of(const StudyResults& study, Metric metric);

// The estimand that decides who is better: the share of solves within the tolerance, if the study has one and its plan
// asks for it, else the plan's first estimand. The others are exploratory.
results::Estimand primary_estimand(const StudyResults& study);

// Errors up to this size count as equal, in the metric's unit; not defined if the study has no such tolerance.
double tolerance_of(const StudyResults& study, Metric metric);

// The value of a solve that counts. An outlying time counts as usual (undisturbed_seconds). An error below the study's
// tolerance, or without one below rounding, counts as that. Other values stay. `study` must outlive the result.
ValueOf counted_value(const StudyResults& study, Metric metric);

// Returns whether a solve that is not ok costs `penalty` times the limit (PAR10): costs in studies with a tolerance.
// The limit is the study's. Without one it is what the dearest solve of all solvers cost.
bool is_penalised(const StudyResults& study, Metric metric);
std::string penalty_words(const StudyResults& study, Metric metric);  // "failures: 10 times the limit"
// `study` must outlive the result. mean: the average of the counted value (average_of), or the value of the whole run.
// In a study with a tolerance a solve that is not ok is penalised (is_penalised); the cost of a whole run is not
// defined if none of its solves is ok. typical: its
// logarithm to base 10; values below the metric's rounding count as that, and costs are penalised likewise.
// reliability: 1 within the distance, else 0; with a tolerance only status ok counts, without one a missing or infinite
// answer counts 0.
Quantity quantity_of(const StudyResults& study, Metric metric, results::Estimand estimand);

// "within 0.01 cm", of poses without a tolerance "within 0.01 cm, however turned"; with a tolerance "within 0.01 cm and
// inside the joint limits", and of times "solved within 5 ms".
std::string within_words(const StudyResults& study, Metric metric);

}  // namespace ikbench::inference
