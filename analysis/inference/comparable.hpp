// Decides which metrics and solvers of a study may be compared. Every statement on times and evaluations follows it.
// Finds the machines that solved a study.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "analysis/inference/doubt.hpp"
#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/study.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// Solvers whose values of a metric are not compared with others, and why. Evaluations: solvers that nobody counted, and
// programs' claims beside counts of the suite. Times: solvers that other programs disturbed often,
// and, unless the plan says otherwise, programs beside solvers that run here.
Doubts left_out(const StudyResults& study, Metric metric);
std::set<std::string, std::less<>> solvers_left_out(const StudyResults& study, Metric metric);
// Returns the study without left_out(); every statement on the metric uses it.
StudyResults compared_in(StudyResults study, Metric metric);

// Reasons why no times of a study can be compared, because all or all but one solver's are left out. Empty if some can.
Doubts timing_doubts(const StudyResults& study);
bool times_are_comparable(const StudyResults& study);
bool is_comparable(const StudyResults& study,
                   Metric metric);  // times_are_comparable() for times; true for all other metrics
// Doubts to show beside times: timing_doubts(), or else the solvers left out of the comparison.
Doubts times_doubts(const StudyResults& study);

// Doubts that times of several CPUs cannot be compared; empty for one CPU.
Doubts cpu_doubts(const std::set<std::string>& cpus);
// Doubts that the comparison is fair: solvers differ in effort, no gradient method is among them or in a companion, or
// there is one target only.
Doubts fairness_doubts(const StudyResults& study, const JudgedStudies& companions = {});
constexpr std::string_view times_not_judged = "times are not comparable";

// Returns the recorded CPUs, with host names if there are several machines. Two sessions ran on different machines if
// both host name (a machine may reboot) and system start (containers have their own names) differ. So cloud machines
// with one host name count as one, and an unrecorded system start counts as another one.
std::set<std::string> machines_of(std::span<const results::Session> sessions);

}  // namespace ikbench::inference
