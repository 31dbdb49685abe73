#include "experiments/runner.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "experiments/environment.hpp"
#include "experiments/series_key.hpp"
#include "experiments/solve_runner.hpp"
#include "experiments/source_digest.hpp"
#include "experiments/study_writer.hpp"
#include "experiments/workers.hpp"

namespace ikbench::experiments {

using namespace robots;
using namespace solvers;
using namespace results;

namespace {

struct Chained {  // one run of one solver, and how far it is
  const SolveRunner* solve_runner;
  int run;
  int next_point;
  Configuration configuration;  // where the arm is
};

// A study laid out for work. Runs outside, solvers inside: whatever drifts on the machine meanwhile touches all solvers
// alike.
struct Plan {
  explicit Plan(const Study& of, int repeats = 1) : study(of), arm(arm_of(of)), points(of.path->points()) {
    for (const SolverEntry& entry : study.solvers) solve_runners.emplace_back(study, entry, arm, repeats);
    chains.reserve(solve_runners.size() * static_cast<std::size_t>(study.runs));
    for (int run = 1; run <= study.runs; ++run) {
      for (const SolveRunner& solve_runner : solve_runners) chains.push_back({&solve_runner, run, 1, study.initial});
    }
  }
  Plan(const Plan&) = delete;  // solve_runners refer to the arm, chains to the solve_runners
  Plan& operator=(const Plan&) = delete;

  Chained& chain(std::size_t solve_runner, int run) {
    return chains[static_cast<std::size_t>(run - 1) * solve_runners.size() + solve_runner];
  }

  const Study& study;
  Robot arm;
  int points;  // of a run
  std::vector<SolveRunner> solve_runners;
  std::vector<Chained> chains;
};

// The next point of the chain. The arm is where the answer put it, unless that was no configuration at all, or where
// every solve starts.
void move_on(Chained& chain, const SolveRecord& record, Start start) {
  ++chain.next_point;
  if (start != Start::previous || record.status == Status::not_finite) return;
  chain.configuration =
      Eigen::Map<const Eigen::VectorXd>(record.answer_rad.data(), static_cast<Eigen::Index>(record.answer_rad.size()));
}

// Moves every chain to its first point that the store does not have; says how many it has.
std::int64_t move_past_stored(Plan& plan, const Store& store) {
  const Study& study = plan.study;
  std::int64_t stored = 0;
  for (std::size_t c = 0; c < plan.solve_runners.size(); ++c) {
    for (const SolveRecord& record : store.series(plan.solve_runners[c].series().key)) {
      if (record.run > study.runs) continue;
      const auto edited = [&](std::string_view what) {
        return std::invalid_argument(
            fmt::format("the stored solve of run {}, point {} by {} {}; the store was edited, so choose another --out",
                        record.run, record.point, record.solver, what));
      };
      if (record.run < 1) throw edited("has a run number below 1");
      if (record.point > plan.points) throw edited(fmt::format("is beyond the last point, {}", plan.points));
      if (record.answer_rad.size() != static_cast<std::size_t>(study.initial.size())) {
        throw edited(fmt::format("has {} joints instead of {}", record.answer_rad.size(), study.initial.size()));
      }
      Chained& chain = plan.chain(c, record.run);
      if (record.point != chain.next_point)
        throw edited(fmt::format("exists, but the one of point {} is missing", chain.next_point));
      move_on(chain, record, study.start);
      if (!chain.configuration.allFinite()) throw edited("has an answer that is not finite");
      ++stored;
    }
  }
  return stored;
}

// What a run asks of all solvers, which a worker keeps while its chains are of that run: targets of some sets are
// dear to draw.
struct RunTask {
  int run = 0;
  std::vector<Pose> targets = {};
  std::vector<Configuration> starts = {};
};

// Solves what is left of every chain, `jobs` of them at once.
void solve_rest(Plan& plan, int jobs, const std::atomic<bool>* cancelled, RecordQueue::PassOn pass_on) {
  RecordQueue record_queue(std::move(pass_on));
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  const auto is_over = [&] { return has_failed || (cancelled != nullptr && *cancelled); };
  const auto work_on = [&](Chained& chain, RunTask& task) {
    if (chain.next_point > plan.points) return;
    const std::unique_ptr<Solver> solver = chain.solve_runner->make_solver();
    if (task.run != chain.run) {
      task = {chain.run, targets(plan.study, plan.arm, chain.run), starts(plan.study, plan.arm, chain.run)};
    }
    const std::vector<Pose>& poses = task.targets;
    const std::vector<Configuration>& own_starts = task.starts;
    const auto start = [&]() -> const Configuration& {
      return own_starts.empty() ? chain.configuration : own_starts[static_cast<std::size_t>(chain.next_point - 1)];
    };
    chain.solve_runner->warm_up(*solver, poses[static_cast<std::size_t>(chain.next_point - 1)], start());
    while (chain.next_point <= plan.points && !is_over()) {
      SolveRecord record = chain.solve_runner->solve(*solver, poses[static_cast<std::size_t>(chain.next_point - 1)],
                                                     start(), chain.run, chain.next_point);
      if (jobs > 1 && record.timing == Timing::clean) record.timing = Timing::parallel;
      move_on(chain, record, plan.study.start);
      record_queue.hand_in(std::move(record));
    }
  };
  work_together(jobs, [&] {
    RunTask task;
    try {
      for (std::size_t i = next++; i < plan.chains.size() && !is_over(); i = next++) work_on(plan.chains[i], task);
    } catch (...) {
      has_failed = true;  // the others end with the solve they are at
      throw;
    }
  });
}

StudyEntry entry_of(const Plan& plan) {
  StudyEntry entry{.name = plan.study.name, .definition = to_json(plan.study), .series = {}};
  for (const SolveRunner& solve_runner : plan.solve_runners) entry.series.push_back(solve_runner.series());
  return entry;
}

void solve_missing(Plan& plan, Store& store, const RunRequest& request, Progress& progress) {
  std::map<std::string, std::string> session = environment();
  for (const SolverEntry& entry : plan.study.solvers) {
    session["source." + entry.solver] = solver_source_digest(entry.solver);
  }
  session["analysis"] = to_json(plan.study.analysis);  // the study may be saved with another one later
  session["jobs"] = std::to_string(request.jobs);
  session["command"] = request.command;
  const std::int64_t session_id = store.begin_session(session);
  const double stolen_before = stolen_seconds();
  solve_rest(plan, request.jobs, request.cancelled, [&](std::vector<SolveRecord> records) {
    for (SolveRecord& record : records) record.session = session_id;
    store.append(records);
    for (std::size_t i = 0; i < records.size(); ++i) {
      ++progress.done;
      if (request.progress) request.progress(progress);
    }
  });
  if (const double stolen = stolen_seconds() - stolen_before; stolen >= 0) {
    store.add_to_session(session_id, {{"stolen_seconds", fmt::format("{:.2f}", stolen)}});
  }
}

}  // namespace

Progress run(const Study& study, Store& store, const RunRequest& request) {
  const bool times_count = request.jobs == 1 && !is_debug_build();
  Plan plan(study, times_count ? study.repeats : 1);
  store.save_study(entry_of(plan));
  Progress progress{.total = static_cast<std::int64_t>(plan.chains.size()) * plan.points};
  progress.done = progress.reused = move_past_stored(plan, store);
  if (request.progress) request.progress(progress);
  if (progress.done < progress.total) solve_missing(plan, store, request, progress);
  if (progress.done == progress.total) check_is_stored(study, store);
  return progress;
}

LeftAside left_aside(const Study& study, const Store& store) {
  LeftAside aside;
  for (const SolverEntry& entry : study.solvers) {
    const std::string key = series_key(study, entry);
    const std::map<std::string, std::int64_t> solves = store.series_of_configuration(configuration_of(key));
    if (solves.empty() || solves.contains(key)) continue;
    aside.labels.push_back(entry.label);
    for (const auto& [other, count] : solves) aside.solves += count;
  }
  return aside;
}

void check_is_stored(const Study& study, const Store& store) {
  const StudyEntry stored = store.study(study.name);
  const bool same_series = std::ranges::equal(stored.series, study.solvers, {}, &Series::key,
                                              [&](const SolverEntry& entry) { return series_key(study, entry); });
  if (stored.definition == to_json(study) && same_series) return;
  throw std::invalid_argument(fmt::format(
      "another ikbench has meanwhile saved a different study named '{}' in this store; no solve is lost; give the other "
      "study another name or --out, then run this one again for its report",
      study.name));
}

void solve_study(const Study& study, int jobs, const std::function<void(SolveRecord)>& take,
                 const std::atomic<bool>* cancelled) {
  Plan plan(study);
  solve_rest(plan, jobs, cancelled, [&](std::vector<SolveRecord> records) {
    for (SolveRecord& record : records) take(std::move(record));
  });
}

SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target) {
  const Robot arm = arm_of(study);
  const SolveRunner solve_runner(study, entry, arm, 1);
  return solve_runner.solve(*solve_runner.make_solver(), target, study.initial, 1, 1);
}

}  // namespace ikbench::experiments
