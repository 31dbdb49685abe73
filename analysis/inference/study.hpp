// A study for analysis: its solves, solvers and task. Points of one run depend on each other, so the unit of analysis
// is the run: one observation is the mean over its points, or for times the median.
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

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/solve.hpp"
#include "analysis/inference/solve_data.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/analysis_plan.hpp"
#include "results/record.hpp"

namespace ikbench::inference {

struct StudyResults {
  std::string name;
  std::vector<std::string> solvers = {};   // labels, in the order of the study
  int runs = 0;                            // per solver, as defined
  int points = 0;                          // per run, as defined
  std::string departed_from = {};          // the paper that it names but whose arm or task it does not have
  results::AnalysisPlan plan = {};         // decides how it is judged
  std::set<std::string> cpus = {};         // CPUs of its sessions, as far as recorded
  StudyFacts facts = {};                   // from its definition
  std::vector<std::string> external = {};  // solvers that are programs or from libraries
  SolveList solves = {};
  std::shared_ptr<const SolveData> solve_data = std::make_shared<const SolveData>();
  std::vector<double> seconds_per_evaluation = {};  // one per solver; replace measured ones (times.hpp)
  std::map<std::string, int> line_styles = {};      // of its solvers in figures; empty: by their places
  std::vector<std::string> drawn_solvers = {};      // the choice and order of figures; empty: all
};

// The label of its solver.
const std::string& solver_of(const StudyResults& study, const Solve& solve);
// Its place among all solvers of the study, from 0, also where some are left out.
std::size_t place_of(const StudyResults& study, std::string_view solver);
// The line style that it has in all figures, from 1.
int style_of(const StudyResults& study, std::string_view solver);
// The solves of one solver.
std::span<const Solve> solves_of(const StudyResults& study, std::string_view solver);
const SolverFacts& solver_facts(const StudyResults& study, std::string_view solver);
Problem problem_of(const StudyResults& study, const Solve& solve);
// The first solve of each place (run and point), ordered by place.
std::vector<const Solve*> places_of(const StudyResults& study);
// Number of solves by session id.
using SolvesOfSessions = std::map<std::int64_t, std::int64_t>;
SolvesOfSessions solves_of_sessions(const StudyResults& study);
// The wall time of a solve [s], or with seconds_per_evaluation its evaluations times its solver's pace.
double seconds_of(const StudyResults& study, const Solve& solve);
// Returns whether a solve has an answer, counted evaluations and a time.
bool has_pace(const StudyResults& study, const Solve& solve);

// Returns whether a solver of the paper's study is missing, or arm or task differ.
bool departs_from_paper(const StudyResults& study);
// The position error at which a solve ends [cm]; not defined if the study has none.
double tolerance_cm(const StudyResults& study);
// Time limit of a solve [s]: the study's deadline_ms, or else the wall time at which solves end; not defined without
// either.
double deadline_seconds(const StudyResults& study);

// The observations of one solver, by the plan's unit. A run with missing points gives no value; it is counted instead.
struct Sample {
  std::string solver;
  std::vector<double> values = {};
  int incomplete_runs = 0;
  int equal_runs = 0;  // number of runs merged into one value because they repeat each other; else 0
};

// Returns whether the solver has several complete runs with the same targets and the same answers bit for bit. Such
// runs are copies: together they count as one.
bool repeats_itself(const StudyResults& study, std::string_view solver);

// Samples of a metric. If a solver repeats itself, equal runs count as one.
std::vector<Sample> samples(const StudyResults& study, Metric metric);
// Samples of any other value of a run.
using OfRun = std::function<double(Run)>;
std::vector<Sample> samples(const StudyResults& study, const OfRun& value_of);
using ValueOf = std::function<double(const Solve&)>;
using Average = double (*)(std::span<const double>);
// Averages a value over the solves of a run.
OfRun averaged(ValueOf value_of, Average average = statistics::mean);
// The average of a metric: the mean, or for times the median, which one interruption hardly changes.
Average average_of(Metric metric);
std::string_view average_name(Metric metric);  // "mean", "median"
double average_in(const statistics::Description& of, Metric metric);

// Counts of one solver's solves by outcome.
struct SolverCounts {
  std::string solver;
  int solves = 0;
  std::int64_t expected = 0;
  int complete_runs = 0;
  int incomplete_runs = 0;  // begun, with missing points
  std::vector<int> by_status = std::vector<int>(results::status_names.size());
  std::vector<int> by_timing = std::vector<int>(results::timing_names.size());
  int outside_limits = 0;
  double worst_outside_deg = 0;  // excess of the worst joint beyond its limit

  int of(results::Status status) const { return by_status[static_cast<std::size_t>(status)]; }
  int of(results::Timing timing) const { return by_timing[static_cast<std::size_t>(timing)]; }
  // Statuses of its solves that have no answer.
  std::vector<results::Status> without_answer() const;
};

std::vector<SolverCounts> counts(const StudyResults& study);

// Statuses that tables show; those of external programs only if they occurred.
std::vector<results::Status> shown_statuses(const StudyResults& study);

// Returns the study with only the solvers that `is_kept` accepts.
StudyResults of_solvers(StudyResults study, const std::function<bool(std::string_view)>& is_kept);

// Returns the study with the solvers that figures show, in their order.
StudyResults drawn_part(const StudyResults& study);

// Sentences on statuses and missing solves, for notes of tables and figures.
std::vector<std::string> status_notes(const StudyResults& study);

}  // namespace ikbench::inference
