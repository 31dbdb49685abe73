// A study as the analysis sees it: the solves, who took part, and what was to be solved. Points of one run depend on
// each other; the unit of analysis is therefore the run, one observation being the mean over its points, of times the
// median.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/analysis_plan.hpp"
#include "analysis/inference/gathered.hpp"
#include "analysis/inference/metrics.hpp"
#include "analysis/inference/solve.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/analysis_plan.hpp"
#include "results/record.hpp"

namespace ikbench::inference {

struct StudyResults {
  std::string name;
  std::vector<std::string> solvers = {};            // labels, in the order of the study
  int runs = 0;                                     // as defined, per solver
  int points = 0;                                   // as defined, per run
  std::string departed_from = {};                   // paper that it names, but of whose arm or task it is not
  results::AnalysisPlan plan = {};                  // how it is judged
  std::set<std::string> cpus = {};                  // of the sessions in which it was solved, as far as these say
  double stolen_seconds = statistics::not_defined;  // processor time that its sessions' hosts kept from their machines
  StudyFacts facts = {};                            // of its definition
  std::vector<std::string> external = {};  // of the solvers, those that are programs, shared objects or of libraries
  SolveList solves = {};
  std::shared_ptr<const Gathered> gathered = std::make_shared<const Gathered>();
  std::vector<double> seconds_per_evaluation = {};  // that count instead of those measured (times.hpp), as labels
};

// Who solved it: a label.
const std::string& solver_of(const StudyResults& study, const Solve& solve);
// The solves of one solver.
std::span<const Solve> solves_of(const StudyResults& study, std::string_view solver);
// Of somebody else, read from a file.
bool is_imported(const StudyResults& study, std::string_view solver);
const SolverFacts& gathered_of(const StudyResults& study, std::string_view solver);
Problem problem_of(const StudyResults& study, const Solve& solve);
// Of each place, which is a point of a run, the first solve that the study has of it; ordered by place.
std::vector<const Solve*> places_of(const StudyResults& study);
SolvesOfSessions solves_of_sessions(const StudyResults& study);
// The wall time of a solve; with seconds_per_evaluation, what it takes at its solver's.
double seconds_of(const StudyResults& study, const Solve& solve);
// With an answer, evaluations that somebody counted, and a time.
bool has_pace(const StudyResults& study, const Solve& solve);

// Whether a solver of the paper's study is missing, or the arm or the task is another.
bool departs_from_paper(const StudyResults& study);
bool enforces_limits(const StudyResults& study);
// The position error at which a solve ends; not defined where the study has none.
double tolerance_cm(const StudyResults& study);
// By which a solve is in time: the study's deadline_ms, or else the wall time at which it ends; not defined without.
double deadline_seconds(const StudyResults& study);

// The observations of one solver, by the unit of the plan. A run of which points are missing gives no run mean; it is
// counted instead.
struct Sample {
  std::string solver;
  std::vector<double> values = {};
  int incomplete_runs = 0;
  int equal_runs = 0;  // that the values are of, where these repeat each other; else 0
};

// Whether its complete runs, of which there are several, were given the same targets and answered them alike to the
// last bit: such runs are copies, so that all of them together say what one does.
bool repeats_itself(const StudyResults& study, std::string_view solver);

// Where a solver repeats itself, equal runs are one.
std::vector<Sample> samples(const StudyResults& study, Metric metric);
// The same of anything else that solves have.
using OfRun = std::function<double(Run)>;
std::vector<Sample> samples(const StudyResults& study, const OfRun& value_of);
using ValueOf = std::function<double(const Solve&)>;
using Average = double (*)(std::span<const double>);
// The average of a value of the solves.
OfRun averaged(ValueOf value_of, Average average = statistics::mean);
// What stands for several values of a metric: their mean; of times their median, which one interruption of the program
// hardly changes.
Average average_of(Metric metric);
std::string_view average_name(Metric metric);  // "mean", "median"
double average_in(const statistics::Description& of, Metric metric);

// Sums of what became of the solves of one solver.
struct SolverCounts {
  std::string solver;
  int solves = 0;
  std::int64_t expected = 0;
  int complete_runs = 0;
  int incomplete_runs = 0;  // begun, and with points missing
  std::vector<int> by_status = std::vector<int>(results::status_names.size());
  std::vector<int> by_timing = std::vector<int>(results::timing_names.size());
  int outside_limits = 0;
  double worst_outside_deg = 0;  // of the worst joint

  int of(results::Status status) const { return by_status[static_cast<std::size_t>(status)]; }
  int of(results::Timing timing) const { return by_timing[static_cast<std::size_t>(timing)]; }
};

std::vector<SolverCounts> counts(const StudyResults& study);

// Those that tables have: the ones of programs outside only where they occurred.
std::vector<results::Status> shown_statuses(const StudyResults& study);

// The study of some of its solvers.
StudyResults of_solvers(StudyResults study, const std::function<bool(std::string_view)>& is_kept);

// The counts as sentences, to stand beside every table and figure: statuses, what is missing.
std::vector<std::string> status_notes(const StudyResults& study);

}  // namespace ikbench::inference
