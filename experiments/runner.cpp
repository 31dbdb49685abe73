#include "experiments/runner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "experiments/environment.hpp"
#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/solve_runner.hpp"
#include "experiments/study_writer.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace results;

namespace {

// A chain is a run of one solver. This is how far one is that is not done.
struct Chained {
  std::vector<bool> stored;     // one per point, in their order
  Configuration configuration;  // the arm's present configuration
};

// The work of a study. A chain takes one bit, and more only where the store has some of its points.
struct Work {
  Work(const Study& asked, const std::vector<Series>& series, int repeats, int jobs, Shard part = {})
      : study(asked), shard(part), arm(arm_of(asked)), points(asked.path->points()) {
    for (std::size_t s = 0; s < series.size(); ++s)
      solve_runners.emplace_back(study, study.solvers[s], series[s].key, arm, repeats, jobs);
    done.resize(solve_runners.size() * static_cast<std::size_t>(study.runs));
  }
  Work(const Work&) = delete;  // solve_runners refer to the arm
  Work& operator=(const Work&) = delete;

  std::size_t index(std::size_t solver, int run) const {
    return static_cast<std::size_t>(run - 1) * solve_runners.size() + solver;
  }
  // The index of the chain at a place in the order of work. Runs are the outer loop, and solvers take turns at being
  // first, among the runs of which a shard has a part, so that a drift of the machine touches all solvers alike.
  std::size_t index_at(std::size_t place) const {
    const int run = static_cast<int>(place / solve_runners.size()) + 1, parts = study.is_chained() ? 1 : points;
    const int turn = (run - 1) / std::max(1, shard.count / parts);
    return index((place + static_cast<std::size_t>(turn)) % solve_runners.size(), run);
  }
  const SolveRunner& solve_runner(std::size_t index) const { return solve_runners[index % solve_runners.size()]; }
  int run(std::size_t index) const { return static_cast<int>(index / solve_runners.size()) + 1; }

  Chained fresh_chain() const {
    return {.stored = std::vector<bool>(static_cast<std::size_t>(points)), .configuration = study.initial};
  }
  Chained chain(std::size_t index) const {
    const auto entry = begun.find(index);
    return entry == begun.end() ? fresh_chain() : entry->second;
  }
  // The first point from `point` on that the shard has and the store has not; `points` + 1 if there is none.
  int next_point(const Chained& chain, int run, int point) const {
    while (point <= points &&
           (chain.stored[static_cast<std::size_t>(point - 1)] || !contains(shard, study, run, point)))
      ++point;
    return point;
  }

  const Study& study;
  Shard shard;
  Robot arm;
  int points;  // per run
  std::vector<SolveRunner> solve_runners;
  std::vector<bool> done;                // true for chains that miss nothing
  std::map<std::size_t, Chained> begun;  // chains of which the store has a part
};

void move_on(Chained& chain, const SolveRecord& record, Start start) {
  chain.stored[static_cast<std::size_t>(record.point - 1)] = true;
  if (!moves_arm(record, start)) return;
  chain.configuration =
      Eigen::Map<const Eigen::VectorXd>(record.answer_rad.data(), static_cast<Eigen::Index>(record.answer_rad.size()));
}

// Throws if the study would not have made the stored solve next.
void check_stored(const SolveRecord& record, const Work& work, const Chained& chain) {
  const bool is_chained = work.study.is_chained();
  const bool has_place = record.run >= 1 && record.point >= 1 && record.point <= work.points;
  const bool follows =
      has_place && (!is_chained || record.point == 1 || chain.stored[static_cast<std::size_t>(record.point - 2)]);
  const bool can_move = record.answer_rad.size() == static_cast<std::size_t>(work.study.initial.size()) &&
                        (!moves_arm(record, work.study.start) ||
                         std::ranges::all_of(record.answer_rad, [](double angle) { return std::isfinite(angle); }));
  if (follows && can_move) return;
  throw std::invalid_argument(
      fmt::format("the stored solve of run {}, point {} by {} is not what the study makes next; the store was edited, "
                  "so choose another --out",
                  record.run, record.point, record.label));
}

// Notes which solves of each chain the store has; returns how many of them are in the shard.
std::int64_t move_past_stored(Work& work, const Store& store) {
  std::int64_t stored = 0;
  for (std::size_t s = 0; s < work.solve_runners.size(); ++s) {
    std::map<int, Chained> chains;  // by run
    store.each_of_series(work.solve_runners[s].key(), [&](const SolveRecord& record) {
      if (record.run > work.study.runs) return;
      const auto [place, is_new] = chains.try_emplace(record.run);
      Chained& chain = place->second;
      if (is_new) chain = work.fresh_chain();
      check_stored(record, work, chain);
      move_on(chain, record, work.study.start);
      if (contains(work.shard, work.study, record.run, record.point)) ++stored;
    });
    for (auto& [run, chain] : chains) {
      if (work.next_point(chain, run, 1) > work.points)
        work.done[work.index(s, run)] = true;
      else
        work.begun.emplace(work.index(s, run), std::move(chain));
    }
  }
  return stored;
}

// The targets and starts of a run, the same for all solvers. A worker keeps them while its chains are of that run,
// since some sets take long to draw.
struct RunTask {
  int run = 0;
  std::vector<Pose> targets = {};
  std::vector<Configuration> starts = {};
};

// Makes a solve that is only what the solver did: anew if the process stood still for a tenth of its time. None if a
// stop came meanwhile, unless it solved: whoever stops us may have stopped its program first.
template <class Solve>
std::optional<SolveRecord> undisturbed(PauseWatch& pauses, const IsOver& is_over, Solve&& solve) {
  constexpr int most_tries = 10;
  for (int tries = 0; tries < most_tries; ++tries) {
    const auto paused_before = pauses.paused();
    const auto began = PauseWatch::Clock::now();
    SolveRecord record = solve();
    const bool stood_still = 10 * (pauses.paused() - paused_before) > PauseWatch::Clock::now() - began;
    if (!stood_still && (record.status == Status::ok || !is_over())) return record;
    if (is_over()) return std::nullopt;
  }
  throw std::runtime_error(
      fmt::format("this process stood still in each of {} tries of a solve; run the same command again, and it goes on",
                  most_tries));
}

// Solves the rest of every chain, `jobs` chains at once. What is solved is passed on, whatever ends this, such as a
// solve that `check` refuses.
void solve_rest(const Work& work, int jobs, const std::atomic<bool>* cancelled, const TakeSolve& check,
                RecordQueue& record_queue) {
  PauseWatch pauses;
  std::vector<RunTask> tasks(static_cast<std::size_t>(jobs));
  const auto work_on = [&](std::size_t turn, std::size_t worker, const IsOver& is_over) {
    RunTask& task = tasks[worker];
    const std::size_t index = work.index_at(turn);
    const int run = work.run(index);
    if (work.done[index]) return;
    Chained chain = work.chain(index);
    int point = work.next_point(chain, run, 1);
    if (point > work.points) return;
    const SolveRunner& solve_runner = work.solve_runner(index);
    const std::unique_ptr<solvers::Solver> solver = solve_runner.make_solver();
    if (task.run != run) task = {run, targets(work.study, work.arm, run), starts(work.study, work.arm, run)};
    const auto target = [&](int place) -> const Pose& { return task.targets[static_cast<std::size_t>(place - 1)]; };
    const auto start = [&](int place) -> const Configuration& {
      return task.starts.empty() ? chain.configuration : task.starts[static_cast<std::size_t>(place - 1)];
    };
    solve_runner.warm_up(*solver, target(point), start(point), run, point);
    for (; point <= work.points && !is_over(); point = work.next_point(chain, run, point + 1)) {
      std::optional<SolveRecord> record = undisturbed(
          pauses, is_over, [&] { return solve_runner.solve(*solver, target(point), start(point), run, point); });
      if (!record) return;
      if (check) check(*record);
      if (!is_over()) solve_runner.count_failure(*solver);
      move_on(chain, *record, work.study.start);
      record_queue.hand_in(std::move(*record));
    }
  };
  try {
    share_out(work.done.size(), jobs, cancelled, work_on);
  } catch (...) {
    record_queue.flush();
    throw;
  }
  record_queue.flush();
}

// What is odd about solvers that others wrote, by label.
using Oddities = std::map<std::string, std::set<std::string>>;

// Cuts what no reader takes of a solve by a class of whoever calls us, and notes what is to be told.
void tidy(SolveRecord& solve, std::set<std::string>& odd) {
  if (solve.status == Status::not_finite)
    odd.insert("errors or answers are not finite, or have not one number for each joint");
  if (solve.counted_by == CountedBy::nobody)
    odd.insert("it did not ask the objective, so nobody counts its evaluations");
  const std::map<std::string, double> notes = std::exchange(solve.extras, {});
  for (const auto& [name, value] : notes) {
    const std::string cut(base::front(base::one_line(name), 200));
    if (cut != name) odd.insert(fmt::format("names of its notes are cut to {}", base::plain_text));
    solve.extras[cut] = value;
  }
}

// Describes how programs and classes behaved, in the session and as sentences.
std::vector<std::string> tell_of(const Work& work, Oddities& odd, Store& store, std::int64_t session) {
  std::vector<std::string> sentences;
  for (const SolveRunner& solve_runner : work.solve_runners)
    if (const std::string of_program = solve_runner.odd(); !of_program.empty())
      odd[solve_runner.label()].insert(of_program);
  for (const auto& [label, what] : odd) {
    if (what.empty()) continue;
    const std::string all = fmt::format("{}", fmt::join(what, "; "));
    sentences.push_back(fmt::format("{}: {}", label, all));
    store.add_to_session(session, {{"solver." + label, all}});
  }
  return sentences;
}

void solve_missing(Work& work, const StoredStudy& stored, Store& store, const RunRequest& request, Progress& progress) {
  std::map<std::string, std::string> session = environment();
  Oddities odd;
  for (const SolverEntry& entry : work.study.solvers) {
    session["source." + entry.solver] = source_digest_of(entry);
    if (const std::string library = library_of(entry); !library.empty()) session["library." + entry.solver] = library;
    if (entry.own) odd[entry.label];
  }
  for (const LeftOut& left_out : work.study.left_out) session["left_out." + left_out.label] = left_out.why;
  session["jobs"] = std::to_string(request.jobs);
  session["command"] = request.command;
  if (request.shard.count > 1) session["shard"] = request.shard.text();
  session["study"] = work.study.name;
  session["analysis"] = to_json(work.study.plan);  // this and the solvers: the study may be saved with others later
  session["solvers"] = base::text_of(base::Json(labels_of(work.study)));
  const std::int64_t session_id = store.begin_session(session);
  const double stolen_before = stolen_seconds();
  const auto store_them = [&](std::vector<SolveRecord>& records) {
    for (SolveRecord& record : records) {
      record.session = session_id;
      if (const auto own = odd.find(record.label); own != odd.end()) tidy(record, own->second);
    }
    store.append(records);
    for (std::size_t i = 0; i < records.size(); ++i) {
      ++progress.done;
      if (request.progress) request.progress(progress);
    }
  };
  RecordQueue record_queue(store_them, request.patience);
  const auto check = [of_study = check_of(stored)](const SolveRecord& record) {
    try {
      of_study(record);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(fmt::format("{}; it is not stored, as no reader would take it", error.what()));
    }
  };
  solve_rest(work, request.jobs, request.cancelled, check, record_queue);
  progress.notes = tell_of(work, odd, store, session_id);
  if (const double stolen = stolen_seconds() - stolen_before; stolen >= 0) {
    store.add_to_session(session_id, {{"stolen_seconds", fmt::format("{:.2f}", stolen)}});
  }
}

void refuse_another(const StoredStudy& ours, const StoredStudy& now) {
  if (ours.definition.json == now.definition.json &&
      std::ranges::equal(ours.series, now.series, {}, &Series::key, &Series::key))
    return;
  throw std::invalid_argument(fmt::format(
      "another ikbench has meanwhile saved a different study named '{}' in this store; no solve is lost; give the other "
      "study another name or --out, then run this one again for its report",
      ours.name));
}

}  // namespace

Progress run(const Study& study, Store& store, const RunRequest& request) {
  return run(study, stored_study(study), store, request);
}

Progress run(const Study& study, const StoredStudy& stored, Store& store, const RunRequest& request) {
  const bool times_count = request.jobs == 1 && !is_debug_build();
  Work work(study, stored.series, times_count ? study.repeats : 1, request.jobs, request.shard);
  store.save_study(stored);
  Progress progress{.total = solves_of(request.shard, study)};
  progress.done = progress.reused = move_past_stored(work, store);
  if (request.progress) request.progress(progress);
  if (progress.done < progress.total) solve_missing(work, stored, store, request, progress);
  if (progress.done == progress.total) refuse_another(stored, store.study(study.name));
  return progress;
}

LeftAside left_aside(const StoredStudy& study, const Store& store) {
  LeftAside aside;
  for (const Series& series : study.series) {
    const std::int64_t solves = store.solves_of_other_sources(series.key);
    if (solves == 0 || store.number_of_solves({study.name, study.definition, {series}}) > 0) continue;
    aside.labels.push_back(series.label);
    aside.solves += solves;
  }
  return aside;
}

void solve_study(const Study& study, int jobs, const std::function<void(SolveRecord)>& take,
                 const std::atomic<bool>* cancelled) {
  const Work work(study, series_of(study), 1, jobs);
  RecordQueue record_queue([&](std::vector<SolveRecord>& records) {
    for (SolveRecord& record : records) take(std::move(record));
  });
  solve_rest(work, jobs, cancelled, {}, record_queue);
}

bool moves_arm(const SolveRecord& solve, Start start) {
  return start == Start::previous && solve.status != Status::not_finite;
}

SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target) {
  const Robot arm = arm_of(study);
  const SolveRunner solve_runner(study, entry, series_key(study, entry), arm);
  return solve_runner.solve(*solve_runner.make_solver(), target, study.initial, 1, 1);
}

}  // namespace ikbench::experiments
