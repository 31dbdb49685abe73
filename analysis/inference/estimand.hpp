// A metric as one of its estimands has it: what of a solve goes into an observation, and how the observation is read.
// A mean of values over decades is that of its worst cases; the typical value and the share within a distance are not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/study.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::inference {

constexpr double penalty = 10;
constexpr std::string_view penalty_words = "failures: 10 times the limit";

struct Quantity {
  std::string name;  // of files and anchors: "error", "error-typical", "error-reliability"
  std::string text;  // with its unit in brackets: "typical position error [cm]"
  std::string unit = {};
  Better better = Better::smaller;
  ValueScale scale = ValueScale::plain;
  std::string average = "mean";         // what an observation is of its solves, in words
  OfRun value = {};                     // and as a function
  std::vector<std::string> notes = {};  // what counts as what
};

// The estimand that averages a metric: of times the typical value, because one interruption of a solve would decide a
// mean; of all others the mean.
results::Estimand average_estimand(Metric metric);

// Those of the study's plan that a metric has. The position error has all, the other metrics their average alone; the
// computing time the reliability too where the study has a deadline.
std::vector<results::Estimand> estimands_of(const StudyResults& study, Metric metric);

// By which the study says who is better: the share of solves within the tolerance, where it has one and its plan asks
// for that, else the first estimand of its plan. The others are exploratory.
results::Estimand primary_estimand(const StudyResults& study);

// Up to which errors of the metric are all alike, in its unit; not defined where the study has no such tolerance.
double tolerance_of(const StudyResults& study, Metric metric);

// What of a solve counts: a time that stands out counts as usual (undisturbed_seconds), an error up to the study's
// tolerance counts as the tolerance, or without one, up to rounding as that. Any other value is what it is. `study`
// outlives the result.
ValueOf counted_value(const StudyResults& study, Metric metric);

// Whether a cost of a solve that is not ok counts `penalty` times a limit (PAR10): in studies with a tolerance.
bool is_penalised(const StudyResults& study, Metric metric);
// What a solve may cost at most: the study's limit, or without one what its dearest solve cost.
double limit_of(const StudyResults& study, Metric metric);
// The counted value; penalised where it is a cost in a study with a tolerance.
ValueOf counted_value(const StudyResults& study, Metric metric, double limit);

// `study` outlives the result. mean: the average of the counted value (average_of), or what a run has as a whole. In a
// study with a tolerance a cost of a solve that is not ok counts `penalty` times the study's limit (PAR10), or without
// a limit the largest that any solve has; what a run costs as a whole is not defined where none of its solves is ok.
// typical: its logarithm to base 10, where a value up to the metric's rounding counts as that, and a cost is
// penalised likewise. reliability: 1 within
// the distance, else 0; where the study has a tolerance only with status ok, else also 0 where there is no new answer
// or it is not finite.
Quantity quantity_of(const StudyResults& study, Metric metric, results::Estimand estimand);

// The distance of reliability, in the metric's unit: the study's tolerance, or the plan's within_cm where it has none;
// of times the study's deadline, not defined where it has none.
double distance_of(const StudyResults& study, Metric metric);

// "within 0.01 cm", of poses without a tolerance "within 0.01 cm, however turned"; with a tolerance "within 0.01 cm and
// inside the joint limits", and of times "solved within 0.005 s".
std::string within_words(const StudyResults& study, Metric metric);

}  // namespace ikbench::inference
