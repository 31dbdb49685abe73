// Prepares times for judgement: interruptions by other programs decide nothing, and are reported, and so are
// two speeds of the machine.
#pragma once

#include <string>
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
// median_speed_words, and the solvers for which they are not true.
std::string speed_note(const StudyResults& study);

// Returns a solve's time, or its usual time if it took more than three times as long (outlier_doubts). `study` must
// outlive the result.
ValueOf undisturbed_seconds(const StudyResults& study);

// Doubts of solves that took more than three times their usual time, and what the machine did meanwhile. The usual time
// is the shortest repeat or, without repeats, the time of at_median_speed().
Doubts outlier_doubts(const StudyResults& study);

// Doubts of solves that were not repeated as often as the study's `repeats` now says.
Doubts repeat_doubts(const StudyResults& study);

// Doubts that the machine was loaded, because many of one solver's solves took long.
Doubts load_doubts(const StudyResults& study);

// Two speeds show in every solver as two groups of seconds per evaluation with almost nothing between. Takes clean
// times of solves with at least half the usual evaluations; in shorter ones overhead counts too much. Empty with fewer
// than two such solvers.
Doubts speed_doubts(const StudyResults& study);

}  // namespace ikbench::inference
