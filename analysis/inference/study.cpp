#include "analysis/inference/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// A solver's solves, by run.
std::vector<std::span<const Solve>> runs_of(const StudyResults& study, std::string_view solver) {
  std::vector<std::span<const Solve>> runs;
  std::span<const Solve> rest = solves_of(study, solver);
  while (!rest.empty()) {
    const auto end = std::ranges::find_if(rest, [&](const Solve& solve) { return solve.run != rest.front().run; });
    runs.push_back(rest.first(static_cast<std::size_t>(end - rest.begin())));
    rest = rest.subspan(runs.back().size());
  }
  return runs;
}

bool complete(std::span<const Solve> run, const StudyResults& study) {
  return static_cast<int>(run.size()) == study.points;
}

bool are_copies(std::span<const Solve> run, std::span<const Solve> other) {
  return std::ranges::equal(run, other, [](const Solve& a, const Solve& b) {
    const bool has_no_answer = is_without_answer(a.status) || a.status == Status::not_verified;
    return a.problem == b.problem && a.status == b.status &&
           (has_same_answer(a, b) || (has_no_answer && a.position_error_cm == b.position_error_cm));
  });
}

// Joins runs that are copies to one. Values measured anew in each run, such as times, differ and stay.
void join_equal_runs(Sample& sample, std::size_t runs) {
  if (runs == 0 || sample.values.size() % runs != 0) return;
  const auto of_a_run = static_cast<std::ptrdiff_t>(sample.values.size() / runs);
  const auto is_same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  for (auto run = sample.values.begin(); run != sample.values.end(); run += of_a_run) {
    if (!std::equal(run, run + of_a_run, sample.values.begin(), is_same)) return;
  }
  sample.values.resize(static_cast<std::size_t>(of_a_run));
  sample.equal_runs = static_cast<int>(runs);
}

}  // namespace

const std::string& solver_of(const StudyResults& study, const Solve& solve) {
  return study.solve_data->labels[solve.solver];
}

std::size_t place_of(const StudyResults& study, std::string_view solver) {
  const std::vector<std::string>& all = study.solve_data->labels;
  return static_cast<std::size_t>(std::ranges::find(all, solver) - all.begin());
}

std::span<const Solve> solves_of(const StudyResults& study, std::string_view solver) {
  const std::size_t number = place_of(study, solver);
  // Not equal_range, which clang++ 14 cannot compile with this library.
  return {std::ranges::lower_bound(study.solves, number, {}, &Solve::solver),
          std::ranges::upper_bound(study.solves, number, {}, &Solve::solver)};
}

bool is_imported(const StudyResults& study, std::string_view solver) {
  const std::span<const Solve> solves = solves_of(study, solver);
  return !solves.empty() && solves.front().timing == Timing::imported;
}

const SolverFacts& solver_facts(const StudyResults& study, std::string_view solver) {
  static const SolverFacts none;
  const SolveData& all = *study.solve_data;
  const auto found = std::ranges::find(all.labels, solver);
  return found == all.labels.end() ? none : all.of_solver[static_cast<std::size_t>(found - all.labels.begin())];
}

Problem problem_of(const StudyResults& study, const Solve& solve) { return study.solve_data->problems[solve.problem]; }

std::vector<const Solve*> places_of(const StudyResults& study) {
  const auto place = [](const Solve* solve) { return std::pair(solve->run, solve->point); };
  std::vector<const Solve*> all;
  for (const std::string& solver : study.solve_data->labels) {
    std::vector<const Solve*> own, both;
    for (const Solve& solve : solves_of(study, solver)) own.push_back(&solve);
    std::ranges::set_union(all, own, std::back_inserter(both), {}, place, place);
    all = std::move(both);
  }
  return all;
}

SolvesOfSessions solves_of_sessions(const StudyResults& study) {
  std::vector<std::int64_t> counts(study.solve_data->sessions.size());
  for (const Solve& solve : study.solves) ++counts[solve.session];
  SolvesOfSessions of_sessions;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) of_sessions[study.solve_data->sessions[i]] = counts[i];
  }
  return of_sessions;
}

bool has_pace(const StudyResults& study, const Solve& solve) {
  return value_of(study, solve, Metric::evaluations) > 0 && solve.seconds > 0 && std::isfinite(solve.seconds);
}

double seconds_of(const StudyResults& study, const Solve& solve) {
  if (study.seconds_per_evaluation.empty() || !has_pace(study, solve)) return solve.seconds;
  return study.seconds_per_evaluation[solve.solver] * static_cast<double>(solve.evaluations);
}

bool departs_from_paper(const StudyResults& study) {
  return !study.departed_from.empty() || !study.facts.missing_solvers.empty();
}

bool enforces_limits(const StudyResults& study) { return study.facts.enforces_limits; }

double tolerance_cm(const StudyResults& study) {
  const double tolerance = study.facts.stop.tolerance_cm;
  return tolerance > 0 ? tolerance : not_defined;
}

double deadline_seconds(const StudyResults& study) {
  const double deadline = study.facts.deadline_ms / 1000, stop = study.facts.stop.seconds;
  return deadline > 0 ? deadline : stop > 0 ? stop : not_defined;
}

std::vector<Sample> samples(const StudyResults& study, Metric metric) {
  std::vector<Sample> result = samples(study, [&](Run run) { return value_of(study, run, metric); });
  if (metric != Metric::evaluations) return result;
  for (Sample& sample : result) {
    const std::span<const Solve> solves = solves_of(study, sample.solver);
    if (std::ranges::find(solves, CountedBy::nobody, &Solve::counted_by) != solves.end()) sample.values.clear();
  }
  return result;
}

OfRun averaged(ValueOf value_of, Average average) {
  return [value_of = std::move(value_of), average](Run run) {
    std::vector<double> values;
    for (const Solve* solve : run) values.push_back(value_of(*solve));
    return average(values);
  };
}

std::vector<Sample> samples(const StudyResults& study, const OfRun& value_of) {
  std::vector<Sample> result;
  std::vector<const Solve*> solves;
  for (const std::string& solver : study.solvers) {
    Sample sample{.solver = solver};
    std::size_t complete_runs = 0;
    for (const std::span<const Solve> run : runs_of(study, solver)) {
      complete_runs += complete(run, study) ? 1 : 0;
      solves.clear();
      for (const Solve& solve : run) solves.push_back(&solve);
      if (study.plan.unit == Unit::point) {
        for (const Solve* const& solve : solves) sample.values.push_back(value_of(Run(&solve, 1)));
      } else if (complete(run, study)) {
        sample.values.push_back(value_of(solves));
      } else {
        ++sample.incomplete_runs;
      }
    }
    if (repeats_itself(study, solver)) join_equal_runs(sample, complete_runs);
    result.push_back(std::move(sample));
  }
  return result;
}

bool repeats_itself(const StudyResults& study, std::string_view solver) {
  std::vector<std::span<const Solve>> runs = runs_of(study, solver);
  std::erase_if(runs, [&](std::span<const Solve> run) { return !complete(run, study); });
  return runs.size() > 1 && std::ranges::all_of(runs, [&](std::span<const Solve> run) {
           return run.data() == runs.front().data() || are_copies(runs.front(), run);
         });
}

Average average_of(Metric metric) { return info_of(metric).kind == Kind::time ? median : mean; }

std::string_view average_name(Metric metric) { return info_of(metric).kind == Kind::time ? "median" : "mean"; }

double average_in(const Description& of, Metric metric) {
  return info_of(metric).kind == Kind::time ? of.median : of.mean;
}

std::vector<SolverCounts> counts(const StudyResults& study) {
  std::vector<SolverCounts> result;
  for (const std::string& solver : study.solvers) {
    SolverCounts count{.solver = solver, .expected = std::int64_t{study.runs} * study.points};
    for (const std::span<const Solve> run : runs_of(study, solver)) {
      ++(complete(run, study) ? count.complete_runs : count.incomplete_runs);
      for (const Solve& solve : run) {
        ++count.solves;
        ++count.by_status[static_cast<std::size_t>(solve.status)];
        ++count.by_timing[static_cast<std::size_t>(solve.timing)];
        if (solve.is_outside_limits) ++count.outside_limits;
        count.worst_outside_deg = study.solve_data->of_solver[solve.solver].worst_outside_deg;
      }
    }
    result.push_back(count);
  }
  return result;
}

std::vector<Status> shown_statuses(const StudyResults& study) {
  std::vector<Status> shown;
  for (std::size_t i = 0; i < status_names.size(); ++i) {
    const auto status = static_cast<Status>(i);
    const bool occurred = std::ranges::find(study.solves, status, &Solve::status) != study.solves.end();
    if (occurred || status <= Status::not_finite) shown.push_back(status);
  }
  return shown;
}

StudyResults of_solvers(StudyResults study, const std::function<bool(std::string_view)>& is_kept) {
  std::vector<std::span<const Solve>> parts;
  std::size_t solves = 0;
  for (const std::string& solver : study.solve_data->labels) {
    if (is_kept(solver)) parts.push_back(solves_of(study, solver));
    if (is_kept(solver)) solves += parts.back().size();
  }
  std::vector<Solve> kept;
  kept.reserve(solves);
  for (const std::span<const Solve> part : parts) kept.insert(kept.end(), part.begin(), part.end());
  study.solves = SolveList(std::move(kept));
  std::erase_if(study.solvers, std::not_fn(is_kept));
  std::erase_if(study.external, std::not_fn(is_kept));
  if (!is_kept(study.plan.control)) study.plan.control.clear();
  return study;
}

std::vector<std::string> status_notes(const StudyResults& study) {
  std::vector<int> by_status(status_names.size());
  const std::vector<Status> shown = shown_statuses(study);
  int solves = 0;
  std::int64_t expected = 0;
  int incomplete_runs = 0;
  for (const SolverCounts& count : counts(study)) {
    for (std::size_t i = 0; i < by_status.size(); ++i) by_status[i] += count.by_status[i];
    solves += count.solves;
    expected += count.expected;
    incomplete_runs += count.incomplete_runs;
  }
  std::string note = fmt::format("Solves: {} of {} expected; by status:", solves, expected);
  for (const Status status : shown) {
    note += fmt::format("{} {} {}", status == shown.front() ? "" : ",", name_of(status),
                        by_status[static_cast<std::size_t>(status)]);
  }
  std::vector<std::string> notes{note + "."};
  if (solves < expected) {
    notes.push_back(
        fmt::format("The study is incomplete. Runs with missing points: {}; they have no mean, and only complete runs "
                    "are observations.",
                    incomplete_runs));
  }
  const auto by_time = std::ranges::count(study.solves, StopReason::time, &Solve::stop_reason);
  if (by_time > 0) {
    notes.push_back(fmt::format(
        "{} of {} solves ended by their time. Schedules that end with a solve did not end in these: they were planned "
        "for its iterations.",
        by_time, study.solves.size()));
  }
  if (by_status[static_cast<std::size_t>(Status::refused)] > 0) {
    notes.push_back(
        "A refused answer leaves the arm where it was: the error that counts is the one it has there, and its "
        "variation "
        "is 0.");
  }
  if (std::ranges::any_of(shown, is_without_answer)) {
    notes.push_back(
        "A program that crashed, timed out, broke the protocol or declined gave no answer: the arm stays where it was, "
        "and the error that counts is the one it has there. Such a solve has no time, no evaluations and no move: in "
        "these it ranks last.");
  }
  if (const int over = by_status[static_cast<std::size_t>(Status::over_budget)]; over > 0) {
    notes.push_back(fmt::format(
        "{} solves of programs took far more than their budget of time or evaluations (over_budget). They do "
        "not count as solved, but their errors are those of what they spent.",
        over));
  }
  if (by_status[static_cast<std::size_t>(Status::not_finite)] > 0) {
    notes.push_back(
        "Answers that are not finite are not left out: a run that has one has no mean error, ranks as the worst in "
        "median "
        "and quartiles, and leaves the mean, standard deviation and maximum of its solver not defined.");
  }
  return notes;
}

}  // namespace ikbench::inference
