#include "analysis/inference/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/text.hpp"

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
    return a.problem == b.problem && a.status == b.status &&
           (has_same_answer(a, b) || (is_without_answer(a.status) && a.position_error_cm == b.position_error_cm));
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

int style_of(const StudyResults& study, std::string_view solver) {
  const auto found = study.line_styles.find(std::string(solver));
  return found != study.line_styles.end() ? found->second : static_cast<int>(place_of(study, solver)) + 1;
}

std::span<const Solve> solves_of(const StudyResults& study, std::string_view solver) {
  const std::size_t number = place_of(study, solver);
  // Not equal_range, which clang++ 14 cannot compile with this library.
  return {std::ranges::lower_bound(study.solves, number, {}, &Solve::solver),
          std::ranges::upper_bound(study.solves, number, {}, &Solve::solver)};
}

const SolverFacts& solver_facts(const StudyResults& study, std::string_view solver) {
  static const SolverFacts none;
  const std::vector<SolverFacts>& all = study.solve_data->of_solver;
  const std::size_t place = place_of(study, solver);
  return place < all.size() ? all[place] : none;
}

Problem problem_of(const StudyResults& study, const Solve& solve) { return study.solve_data->problems[solve.problem]; }

std::vector<const Solve*> places_of(const StudyResults& study) {
  const auto place = [](const Solve* solve) { return std::pair(solve->run, solve->point); };
  std::vector<const Solve*> all;
  for (const Solve& solve : study.solves) all.push_back(&solve);
  std::ranges::stable_sort(all, {}, place);
  const auto is_same = [&](const Solve* one, const Solve* other) { return place(one) == place(other); };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
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
  for (Sample& sample : result) {
    const std::span<const Solve> solves = solves_of(study, sample.solver);
    const bool is_uncounted = std::ranges::find(solves, CountedBy::nobody, &Solve::counted_by) != solves.end();
    if (metric == Metric::evaluations && is_uncounted) sample.values.clear();
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
    SolverCounts count{.solver = solver,
                       .expected = std::int64_t{study.runs} * study.points,
                       .worst_outside_deg = solver_facts(study, solver).worst_outside_deg};
    for (const std::span<const Solve> run : runs_of(study, solver)) {
      ++(complete(run, study) ? count.complete_runs : count.incomplete_runs);
      for (const Solve& solve : run) {
        ++count.solves;
        ++count.by_status[static_cast<std::size_t>(solve.status)];
        ++count.by_timing[static_cast<std::size_t>(solve.timing)];
        if (solve.is_outside_limits) ++count.outside_limits;
      }
    }
    result.push_back(count);
  }
  return result;
}

std::vector<Status> SolverCounts::without_answer() const {
  std::vector<Status> statuses;
  for (std::size_t i = 0; i < by_status.size(); ++i) {
    const auto status = static_cast<Status>(i);
    if (by_status[i] > 0 && is_without_answer(status)) statuses.push_back(status);
  }
  return statuses;
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
  std::vector<Solve> kept;
  for (const std::string& solver : study.solve_data->labels) {
    const std::span<const Solve> own = is_kept(solver) ? solves_of(study, solver) : std::span<const Solve>();
    kept.insert(kept.end(), own.begin(), own.end());
  }
  study.solves = SolveList(std::move(kept));
  std::erase_if(study.solvers, std::not_fn(is_kept));
  std::erase_if(study.external, std::not_fn(is_kept));
  if (!is_kept(study.plan.control)) study.plan.control.clear();
  return study;
}

StudyResults drawn_part(const StudyResults& study) {
  std::vector<std::string> drawn = study.drawn_solvers;
  std::erase_if(drawn, [&](const std::string& solver) { return std::ranges::count(study.solvers, solver) == 0; });
  if (drawn.empty()) return study;
  StudyResults part =
      of_solvers(study, [&](std::string_view solver) { return std::ranges::find(drawn, solver) != drawn.end(); });
  part.solvers = std::move(drawn);
  return part;
}

std::vector<std::string> status_notes(const StudyResults& study) {
  SolverCounts all;
  for (const SolverCounts& count : counts(study)) {
    for (std::size_t i = 0; i < all.by_status.size(); ++i) all.by_status[i] += count.by_status[i];
    all.solves += count.solves;
    all.expected += count.expected;
    all.incomplete_runs += count.incomplete_runs;
  }
  const std::vector<Status> shown = shown_statuses(study);
  std::vector<std::string> by_status;
  for (const Status status : shown) {
    if (all.of(status) > 0) by_status.push_back(fmt::format("{} {}", all.of(status), in_words(name_of(status))));
  }
  const auto by_time = std::ranges::count(study.solves, StopReason::time, &Solve::stop_reason);
  const std::pair<bool, std::string> notes[]{
      {true, fmt::format("Solves: {} of {} expected{}{}.", all.solves, all.expected, by_status.empty() ? "" : ": ",
                         fmt::join(by_status, ", "))},
      {all.solves < all.expected,
       fmt::format("The study is incomplete. Runs with missing points: {}; they have no mean, and only complete runs "
                   "are observations.",
                   all.incomplete_runs)},
      {by_time > 0,
       fmt::format("{} of {} solves ended by their time. Schedules that end with a solve did not end in these: they "
                   "were planned for its iterations.",
                   by_time, study.solves.size())},
      {all.of(Status::refused) > 0,
       "A refused answer leaves the arm where it was: the error that counts is the one it has there, and its variation "
       "is 0."},
      {std::ranges::any_of(shown, is_without_answer),
       "A program that crashed, timed out, broke the protocol or declined gave no answer: the arm stays where it was, "
       "and the error that counts is the one it has there. Such a solve has no time, no evaluations and no move: in "
       "these it ranks last."},
      {all.of(Status::over_budget) > 0,
       fmt::format("{} solves of programs took far more than their budget of time or evaluations (over budget). They "
                   "do not count as solved, but their errors are those of what they spent.",
                   all.of(Status::over_budget))},
      {all.of(Status::not_finite) > 0,
       "Answers that are not finite are not left out: a run that has one has no mean error, ranks as the worst in "
       "median and quartiles, and leaves the mean, standard deviation and maximum of its solver not defined."}};
  std::vector<std::string> result;
  for (const auto& [is_so, note] : notes) {
    if (is_so) result.push_back(note);
  }
  return result;
}

}  // namespace ikbench::inference
