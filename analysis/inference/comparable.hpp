// What may be held against each other: which metrics of a study, and which of its solvers. All that is said of times
// and evaluations follows it.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The solvers whose values of a metric are held against no others', and why; the others are compared
// without them. Of evaluations: those that nobody counted, and beside solvers that the suite counted those that a
// program claims. Of times: those of imported solves, those of which many were disturbed by other programs, and, unless
// the plan says otherwise, those of programs beside solvers that run here.
struct LeftOut {
  std::set<std::string, std::less<>> solvers = {};
  Doubts doubts = {};
};
LeftOut left_out(const StudyResults& study, Metric metric);
// What is said of a metric is said of this study: without these.
StudyResults compared_in(StudyResults study, Metric metric);

// Why no times of a study can be compared: all of them, or all but one solver's, are left out. None where some can.
Doubts timing_doubts(const StudyResults& study);
bool times_are_comparable(const StudyResults& study);
bool is_comparable(const StudyResults& study, Metric metric);  // all metrics are but times
// Why the times of one solver are held against no others', or those of the whole study; none where they are.
Doubts timing_doubts(const StudyResults& study, std::string_view solver);
// Beside times: timing_doubts(), or else which solvers are left out of their comparison.
Doubts times_doubts(const StudyResults& study);

// Whether other programs were at work while a solver's solves ran that are recorded as clean or as those of a program:
// whether many of these took longer than their CPU time, or waited as long for a processor. One does not matter.
bool times_were_disturbed(const StudyResults& study, std::string_view solver);
// Whether the solver is a process of its own, whose times have its messages in them.
bool is_program(const StudyResults& study, std::string_view solver);
// Times of several CPUs cannot be compared; none where there are not several.
Doubts cpu_doubts(const std::set<std::string>& cpus);
// Of the programs whose time is for the most part that of their messages.
Doubts transport_doubts(const StudyResults& study);
// Whose candidates are evaluated in another way than those of built-in solvers, where there are both.
Doubts evaluation_doubts(const StudyResults& study);
constexpr std::string_view times_not_judged = "times are not comparable";

}  // namespace ikbench::inference
