#include "experiments/runner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "experiments/environment.hpp"
#include "experiments/external/external_solver.hpp"
#include "experiments/solve_runner.hpp"
#include "experiments/stored_checks.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/study/writer.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace results;

namespace {

// The unit of scheduling: one run if each solve starts at the previous answer, otherwise one target.
struct Part {
  int run = 1, first = 1, last = 1;  // points
};

// The work of a study, and which of its solves are stored.
struct StudyWork {
  StudyWork(const Study& asked, const std::vector<Series>& series, int jobs, Shard shard_of_it = {})
      : study(asked), shard(shard_of_it), arm(robot_of(asked)), points(asked.path->points()) {
    for (std::size_t s = 0; s < series.size(); ++s)
      solve_runners.emplace_back(study, study.solvers[s], series[s].key, arm, jobs);
    stored.resize(solve_runners.size(), std::vector<bool>(place(study.runs, points) + 1));
  }
  StudyWork(const StudyWork&) = delete;  // solve_runners refer to the arm
  StudyWork& operator=(const StudyWork&) = delete;

  std::size_t place(int run, int point) const {
    return static_cast<std::size_t>(run - 1) * static_cast<std::size_t>(points) + static_cast<std::size_t>(point - 1);
  }
  bool has(std::size_t solver, int run, int point) const { return stored[solver][place(run, point)]; }
  // Returns the first point of a part that is not stored, or the one after its last if all are.
  int next_point(std::size_t solver, const Part& part) const {
    int point = part.first;
    while (point <= part.last && has(solver, part.run, point)) ++point;
    return point;
  }
  // Returns the configuration where the next solve of a chained run begins.
  Configuration chain_end(std::size_t solver, int run) const {
    const auto stored_chain = left_arm.find({solver, run});
    if (stored_chain == left_arm.end()) return study.initial;
    return stored_chain->second;
  }
  int turns() const {
    return shard.count > 1 ? 1 : static_cast<int>(std::min<std::int64_t>(study.turns, work_unit_count(study)));
  }
  std::vector<Part> parts_in(Shard its) const {
    const int last = study.is_chained() ? 1 : points;
    std::vector<Part> parts;
    for (int run = 1; run <= study.runs; ++run)
      for (int point = 1; point <= last; ++point)
        if (is_in_shard(its, study, run, point)) parts.push_back({run, point, study.is_chained() ? points : point});
    return parts;
  }
  // Returns the missing parts of one turn, grouped by the solvers that lack them: within a session all solvers have the
  // same targets to do. After an interruption the cut targets form a group of their own.
  std::map<std::vector<std::size_t>, std::vector<Part>> sessions_of(int turn) const {
    std::map<std::vector<std::size_t>, std::vector<Part>> sessions;
    for (const Part& part : parts_in(shard.count > 1 ? shard : Shard{.index = turn, .count = turns()})) {
      std::vector<std::size_t> who;
      for (std::size_t s = 0; s < stored.size(); ++s)
        if (next_point(s, part) <= part.last) who.push_back(s);
      if (!who.empty()) sessions[who].push_back(part);
    }
    return sessions;
  }

  const Study& study;
  Shard shard;
  Robot arm;
  int points;  // per run
  std::deque<SolveRunner> solve_runners;
  std::vector<std::vector<bool>> stored;                          // by solver and place
  std::map<std::pair<std::size_t, int>, Configuration> left_arm;  // by solver and run, where a stored chain ends
};

// Throws std::invalid_argument if the study would not have made the stored solve next.
void check_stored(const SolveRecord& record, const StudyWork& work, std::size_t solver) {
  const bool is_chained = work.study.is_chained();
  const bool has_place = record.run >= 1 && record.point >= 1 && record.point <= work.points;
  const bool follows =
      has_place && (!is_chained || record.point == 1 || work.has(solver, record.run, record.point - 1));
  const bool can_move = record.answer_rad.size() == static_cast<std::size_t>(work.study.initial.size()) &&
                        (!continues_from(record, work.study.start) ||
                         std::ranges::all_of(record.answer_rad, [](double angle) { return std::isfinite(angle); }));
  if (follows && can_move) return;
  throw std::invalid_argument(
      fmt::format("the stored solve of run {}, point {} by {} is not what the study makes next; the store was edited, "
                  "so choose another --out",
                  record.run, record.point, record.label));
}

// Notes which solves the store has. Returns how many of them are in the shard.
std::int64_t move_past_stored(StudyWork& work, const Store& store) {
  std::int64_t stored = 0;
  for (std::size_t s = 0; s < work.solve_runners.size(); ++s) {
    store.for_each_in_series(work.solve_runners[s].key(), [&](const SolveRecord& record) {
      if (record.run > work.study.runs) return;
      check_stored(record, work, s);
      work.stored[s][work.place(record.run, record.point)] = true;
      if (record.point < work.points && continues_from(record, work.study.start))
        work.left_arm[{s, record.run}] = to_eigen(record.answer_rad);
      if (record.point == work.points) work.left_arm.erase({s, record.run});
      if (is_in_shard(work.shard, work.study, record.run, record.point)) ++stored;
    });
  }
  return stored;
}

// Runs `solve`, and repeats it (at most 10 times) if this process stood still for more than a tenth of its time.
// Returns nothing if a stop was requested, unless the solve succeeded: who stops this process may have stopped the
// program first.
template <class Solve>
std::optional<SolveRecord> undisturbed(SuspensionWatch& pauses, const StopRequested& is_over, Solve&& solve) {
  constexpr int most_tries = 10;
  for (int tries = 0; tries < most_tries; ++tries) {
    const auto paused_before = pauses.suspended();
    const auto began = SuspensionWatch::Clock::now();
    SolveRecord record = solve();
    const bool stood_still = 10 * (pauses.suspended() - paused_before) > SuspensionWatch::Clock::now() - began;
    if (!stood_still && (record.status == Status::ok || !is_over())) return record;
    if (is_over()) return std::nullopt;
  }
  throw std::runtime_error(
      fmt::format("this process stood still in each of {} tries of a solve; run the same command again, and it goes on",
                  most_tries));
}

// Asks the study's check about an answer that reached its target. Returns false if a stop was requested and the check
// failed.
bool is_checked(const StudyWork& work, std::unique_ptr<ChildProcess>& checker, SolveRecord& record,
                const StopRequested& is_over) {
  try {
    if (work.study.checker && record.status == Status::ok) check_answer(work.study, work.arm, checker, record);
    return true;
  } catch (const ProcessFailure& trouble) {
    const std::string told = trouble.why + (checker ? checker->end_after(trouble.kind) : "");
    if (is_over()) return false;
    throw std::invalid_argument(fmt::format("[check] of {}, run {}, point {}: {}; what is stored is kept", record.label,
                                            record.run, record.point, told));
  }
}

// Returns a drawn order of the solvers. Each second turn has the order of the turn before, reversed.
std::vector<std::size_t> order_of(const Study& study, std::vector<std::size_t> solvers, int turn) {
  numerics::Random random(numerics::Key(study.seed).with("order").with(static_cast<std::uint64_t>((turn + 1) / 2)));
  for (std::size_t left = solvers.size(); left > 1; --left)
    std::swap(solvers[left - 1], solvers[static_cast<std::size_t>(random.index(static_cast<int>(left)))]);
  if (turn % 2 == 0) std::ranges::reverse(solvers);
  return solvers;
}

// The state of a worker in a session: its solvers, and the targets and starts of its current run, which may take long
// to draw.
struct WorkerState {
  std::vector<std::unique_ptr<solvers::Solver>> solvers = {};
  std::unique_ptr<ChildProcess> checker = {};  // null until it is needed
  int at_run = 0;
  std::vector<Pose> poses = {};
  std::vector<Configuration> own_starts = {};

  // Returns the question at a point. A chain continues at `left_arm`.
  SolveRequest call_at(const StudyWork& work, int run, int point, const Configuration& left_arm) {
    if (std::exchange(at_run, run) != run)
      poses = targets_of_run(work.study, work.arm, run), own_starts = starts_of_run(work.study, work.arm, run);
    const auto place = static_cast<std::size_t>(point - 1);
    return {poses[place], own_starts.empty() ? left_arm : own_starts[place], run, point};
  }
  void prepare(const StudyWork& work, const std::vector<std::size_t>& which, const std::vector<Part>& parts,
               std::size_t together) {
    const SolveRequest call = call_at(work, parts.back().run, parts.back().last, work.study.initial);
    for (const std::size_t s : which) {
      solvers.push_back(work.solve_runners[s].make_solver());
      work.solve_runners[s].warm_up(*solvers.back(), call, std::min(together, parts.size()));
    }
  }
};

// Solves what these solvers lack of the parts, `jobs` at once. Their batches have one size. A group is one part, the
// parts of a batch, or two parts if a call on the other comes between the two calls on a target. All solvers take turns
// at being first in a group. Solves are passed on whatever ends this, such as a solve that `check` refuses.
void solve_with_batch_size(const StudyWork& work, const std::vector<std::size_t>& solvers,
                           const std::vector<Part>& parts, int jobs, const std::atomic<bool>* cancelled,
                           const SolveVisitor& check, RecordQueue& record_queue) {
  const auto batch = static_cast<std::size_t>(work.solve_runners[solvers.front()].batch());
  const bool is_hot = work.study.state == CacheState::warm && batch == 0;
  const std::size_t together = std::max<std::size_t>(batch, is_hot ? 2 : 1), rest = batch > 0 ? together - 1 : 0;
  const std::size_t groups = std::max<std::size_t>(1, (parts.size() + rest) / together);  // the rest is a batch, too
  SuspensionWatch pauses;
  std::vector<WorkerState> benches(static_cast<std::size_t>(jobs));
  const auto work_on = [&](std::size_t turn, std::size_t worker, const StopRequested& is_over) {
    WorkerState& bench = benches[worker];
    if (bench.solvers.empty()) bench.prepare(work, solvers, parts, together);
    const std::size_t group = turn / solvers.size(), its = (turn + group) % solvers.size(), s = solvers[its];
    const auto first = parts.begin() + static_cast<std::ptrdiff_t>(group * together);
    const auto end = group + 1 == groups ? parts.end() : first + static_cast<std::ptrdiff_t>(together);
    const SolveRunner& solve_runner = work.solve_runners[s];
    solvers::Solver& solver = *bench.solvers[its];
    const auto hand_in = [&](SolveRecord& record) {
      if (!is_checked(work, bench.checker, record, is_over)) return false;
      if (check) check(record);
      record_queue.push(std::move(record));
      return true;
    };
    std::vector<SolveRecord> hot;  // checked after the last call, since a check would cool the caches
    const StopRequested is_cut =
        batch > 0 ? StopRequested([] { return false; }) : is_over;  // a batch is stored whole or not at all
    const auto heated = [&] {
      for (auto part = first; part != end && !is_cut(); ++part)
        solve_runner.warm_call(solver, bench.call_at(work, part->run, part->first, work.study.initial));
      return SolveRecord{.status = batch == 0 || solve_runner.send_batch(solver) ? Status::ok : Status::crashed};
    };
    if ((is_hot || batch > 0) && !undisturbed(pauses, is_over, heated)) return;
    if (batch > 0) solve_runner.count_failure(solver);
    for (auto part = first; part != end; ++part) {
      Configuration left_arm = work.chain_end(s, part->run);
      for (int point = work.next_point(s, *part); point <= part->last && !is_cut(); ++point) {
        const SolveRequest call = bench.call_at(work, part->run, point, left_arm);
        std::optional<SolveRecord> record =
            undisturbed(pauses, is_cut, [&] { return solve_runner.solve(solver, call); });
        if (!record) break;
        if (!is_over()) solve_runner.count_failure(solver);
        if (continues_from(*record, work.study.start)) left_arm = to_eigen(record->answer_rad);
        if (is_hot && work.study.checker)
          hot.push_back(std::move(*record));
        else if (!hand_in(*record))
          break;
      }
    }
    for (SolveRecord& record : hot)
      if (!hand_in(record)) break;
  };
  try {
    parallel_for(groups * solvers.size(), jobs, cancelled, work_on);
  } catch (...) {
    record_queue.flush();
    throw;
  }
  record_queue.flush();
  benches.clear();
  for (const std::size_t s : solvers) work.solve_runners[s].end_processes();
}

void solve_multiverse(const StudyWork& work, const std::vector<std::size_t>& solvers, const std::vector<Part>& parts,
                      int jobs, const std::atomic<bool>* cancelled, const SolveVisitor& check,
                      RecordQueue& record_queue) {
  std::map<int, std::vector<std::size_t>> by_batch;
  for (const std::size_t s : solvers) by_batch[work.solve_runners[s].batch()].push_back(s);
  for (const auto& [batch, alike] : by_batch)
    solve_with_batch_size(work, alike, parts, jobs, cancelled, check, record_queue);
}

// The anomalies of programs and users' classes, by label.
using Anomalies = std::map<std::string, std::set<std::string>>;

// Cuts names of notes to what the store takes, and notes anomalies of a user's class.
void tidy(SolveRecord& solve, std::set<std::string>& odd) {
  if (solve.status == Status::not_finite)
    odd.insert("errors or answers are not finite, or have not one number for each joint");
  if (solve.counted_by == CountedBy::none) odd.insert("it did not ask the objective, so nobody counts its evaluations");
  const std::map<std::string, double> notes = std::exchange(solve.extras, {});
  for (const auto& [name, value] : notes) {
    const std::string cut(base::front(base::one_line(name), 200));
    if (cut != name) odd.insert(fmt::format("names of its notes are cut to {}", base::plain_text));
    solve.extras[cut] = value;
  }
}

// Returns sentences on the anomalies of programs and classes, and adds them to the session.
std::vector<std::string> tell_of(const StudyWork& work, Anomalies& odd, Store& store, std::int64_t session) {
  std::vector<std::string> sentences;
  for (const SolveRunner& solve_runner : work.solve_runners)
    if (const std::string of_program = solve_runner.anomalies(); !of_program.empty())
      odd[solve_runner.label()].insert(of_program);
  for (const auto& [label, what] : odd) {
    if (what.empty()) continue;
    const std::string all = fmt::format("{}", fmt::join(what, "; "));
    sentences.push_back(fmt::format("{}: {}", label, all));
    store.add_to_session(session, {{"solver." + label, all}});
  }
  return sentences;
}

void solve_missing(StudyWork& work, const StoredStudy& stored, Store& store, const RunRequest& request,
                   Progress& progress) {
  std::map<std::string, std::string> session = environment();
  Anomalies odd;
  for (const SolverEntry& entry : work.study.solvers) {
    session["source." + entry.solver] = source_digest_of(entry);
    if (const std::string library = library_name(entry); !library.empty()) session["library." + entry.solver] = library;
    if (entry.custom) odd[entry.label];
  }
  for (const SkippedSolver& left_out : work.study.skipped) session["left_out." + left_out.label] = left_out.reason;
  session["jobs"] = std::to_string(request.jobs);
  session["command"] = request.command;
  if (request.shard.count > 1) session["shard"] = request.shard.text();
  session["study"] = work.study.name;
  session["analysis"] = to_json(work.study.plan);  // with the solvers, because the study may be saved with others later
  session["solvers"] = base::text_of(base::Json(labels_of(work.study)));
  session["state"] = work.study.is_chained() ? std::string_view("runs in a row") : name_of(work.study.state);
  std::int64_t session_id = 0;
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
  RecordQueue record_queue(store_them, request.flush_interval);
  const auto check = [of_study = answer_check(stored)](const SolveRecord& record) {
    try {
      of_study(record);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(fmt::format("{}; it is not stored, as no reader would take it", error.what()));
    }
  };
  const auto is_over = [&] { return request.cancelled != nullptr && *request.cancelled; };
  for (int turn = 1; turn <= work.turns(); ++turn) {
    if (work.turns() > 1) session["turn"] = fmt::format("{}/{}", turn, work.turns());
    for (const auto& [who, parts] : work.sessions_of(turn)) {
      if (is_over()) break;
      session_id = store.begin_session(session);
      solve_multiverse(work, order_of(work.study, who, turn), parts, request.jobs, request.cancelled, check,
                       record_queue);
    }
  }
  progress.anomalies = tell_of(work, odd, store, session_id);
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
  return run(study, to_stored(study), store, request);
}

Progress run(const Study& study, const StoredStudy& stored, Store& store, const RunRequest& request) {
  StudyWork work(study, stored.series, request.jobs, request.shard);
  store.save_study(stored);
  Progress progress{.total = planned_solve_count(request.shard, study)};
  progress.done = progress.reused = move_past_stored(work, store);
  if (request.progress) request.progress(progress);
  if (progress.done < progress.total) solve_missing(work, stored, store, request, progress);
  if (progress.done == progress.total) refuse_another(stored, store.study(study.name));
  return progress;
}

void solve_without_store(const Study& study, int jobs, const std::function<void(SolveRecord)>& take,
                         const std::atomic<bool>* cancelled) {
  const StudyWork work(study, series_of(study), jobs);
  RecordQueue record_queue([&](std::vector<SolveRecord>& records) {
    for (SolveRecord& record : records) take(std::move(record));
  });
  std::vector<std::size_t> all(study.solvers.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  solve_multiverse(work, all, work.parts_in({}), jobs, cancelled, {}, record_queue);
}

bool continues_from(const SolveRecord& solve, Start start) {
  return start == Start::previous && solve.status != Status::not_finite;
}

SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target) {
  const Robot arm = robot_of(study);
  const SolveRunner solve_runner(study, entry, series_key(study, entry), arm);
  const std::unique_ptr<solvers::Solver> solver = solve_runner.make_solver();
  const SolveRequest call{target, study.initial, 1, 1};
  if (solve_runner.batch() > 0) solve_runner.warm_call(*solver, call), solve_runner.send_batch(*solver);
  return solve_runner.solve(*solver, call);
}

}  // namespace ikbench::experiments
