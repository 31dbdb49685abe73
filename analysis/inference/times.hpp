// Replaces times that other programs disturbed, so that these decide nothing, and reports the disturbances.
#pragma once

#include <string_view>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// Replaces each time by the solve's evaluations times its solver's median seconds per evaluation, so that interruptions
// change no sum, quantile or maximum. Keeps times that are no positive number, of solves without an answer, and of
// solvers whose evaluations nobody counts.
StudyResults at_median_speed(StudyResults study);

constexpr std::string_view median_speed_words =
    "Times are those of the evaluations at the median speed of the solver, which an interruption does not change.";

// Returns a solve's time, or its usual time, that of at_median_speed(), if it took more than three times as long and
// was not repeated. `study` must outlive the result.
ValueOf undisturbed_seconds(const StudyResults& study);

// The doubt that the machine was loaded: repeats of many of a solver's solves took very different times.
Doubts load_doubts(const StudyResults& study);

// Doubts of the solves whose usual time counts.
Doubts outlier_doubts(const StudyResults& study);

}  // namespace ikbench::inference
