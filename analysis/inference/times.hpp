// Times as they are judged: what another program adds to one of them must decide nothing, and is told.
#pragma once

#include <string>
#include <string_view>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The study with the time of every solve as its evaluations take at the median speed (seconds per evaluation) of its
// solver. Sums of such times, shares within a time and the longest of them are safe from interruptions too. A time
// that is no positive number stays, and so do those of solves without an answer and of solvers that nobody counts.
StudyResults at_median_speed(StudyResults study);

constexpr std::string_view median_speed_words =
    "Times are those of the evaluations at the median speed of the solver, which an interruption does not change.";
// These words, and of which solvers they are not true.
std::string speed_note(const StudyResults& study);

// The time of a solve; of one that took more than three times as long as usual, its usual time (outlier_doubts).
// `study` outlives the result.
ValueOf undisturbed_seconds(const StudyResults& study);

// Which solves took more than three times as long as usual, and what the machine did meanwhile; none where none did.
// Usual is the shortest repeat, or where there is one alone what at_median_speed() has.
Doubts outlier_doubts(const StudyResults& study);

// Which solves were not made as often as the study's `repeats` now says.
Doubts repeat_doubts(const StudyResults& study);

// The same where so many of one solver's solves took long that the machine was loaded.
Doubts load_doubts(const StudyResults& study);

}  // namespace ikbench::inference
