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
#include <span>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "experiments/diagnosis.hpp"
#include "experiments/environment.hpp"
#include "experiments/external/answers.hpp"
#include "experiments/external/external_solver.hpp"
#include "experiments/known_answers.hpp"
#include "experiments/solve_runner.hpp"
#include "experiments/stored_checks.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/study/writer.hpp"
#include "results/export.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace results;

namespace {

// The unit of scheduling: one run if each solve starts at the previous answer, otherwise one target.
struct WorkUnit {
  int run = 1;
  int first = 1, last = 1;  // points
};

// The work of a study, and which of its solves are stored.
struct StudyWork {
  StudyWork(const Study& asked, const std::vector<Series>& series, int jobs, Shard shard_of_study = {})
      : study(asked), shard(shard_of_study), arm(robot_of(asked)), points(asked.path->points()) {
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
  // Returns the first point of a unit that is not stored, or the one after its last if all are.
  int next_point(std::size_t solver, const WorkUnit& unit) const {
    int point = unit.first;
    while (point <= unit.last && has(solver, unit.run, point)) ++point;
    return point;
  }
  // Returns the configuration where the next solve of a chained run begins.
  Configuration chain_end(std::size_t solver, int run) const {
    const auto stored_chain = left_arm.find({solver, run});
    if (stored_chain == left_arm.end()) return study.initial;
    return stored_chain->second;
  }
  int rounds() const {
    return shard.count > 1 ? 1 : static_cast<int>(std::min<std::int64_t>(study.rounds, work_unit_count(study)));
  }
  std::vector<WorkUnit> units_in(Shard share) const {
    const int last = study.is_chained() ? 1 : points;
    std::vector<WorkUnit> units;
    for (int run = 1; run <= study.runs; ++run) {
      for (int point = 1; point <= last; ++point) {
        if (is_in_shard(share, study, run, point)) units.push_back({run, point, study.is_chained() ? points : point});
      }
    }
    return units;
  }
  // Returns the missing units of one round, grouped by the solvers that lack them: within a session all solvers have
  // the same targets to do. After an interruption the cut targets form a group of their own.
  std::map<std::vector<std::size_t>, std::vector<WorkUnit>> sessions_of(int round) const {
    std::map<std::vector<std::size_t>, std::vector<WorkUnit>> sessions;
    for (const WorkUnit& unit : units_in(shard.count > 1 ? shard : Shard{.index = round, .count = rounds()})) {
      std::vector<std::size_t> lacking;
      for (std::size_t s = 0; s < stored.size(); ++s) {
        if (next_point(s, unit) <= unit.last) lacking.push_back(s);
      }
      if (!lacking.empty()) sessions[lacking].push_back(unit);
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
      fmt::format("the stored solve of run {}, point {} by {} is not the one that the study makes; the store was "
                  "edited, so rerun with --out NEW",
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

// Runs `solve`, and repeats it (at most 10 times) if this process was suspended for more than a tenth of it. Returns
// nothing if a stop was requested, unless the solve succeeded: whoever stops this process may have stopped the program
// first.
template <class Solve>
std::optional<SolveRecord> without_suspension(SuspensionWatch& watch, const StopRequested& is_over, Solve&& solve) {
  constexpr int max_tries = 10;
  for (int tries = 0; tries < max_tries; ++tries) {
    const auto suspended_before = watch.suspended();
    const auto began = SuspensionWatch::Clock::now();
    SolveRecord record = solve();
    const bool was_suspended = 10 * (watch.suspended() - suspended_before) > SuspensionWatch::Clock::now() - began;
    if (!was_suspended && (record.status == Status::ok || !is_over())) return record;
    if (is_over()) return std::nullopt;
  }
  throw std::runtime_error(fmt::format(
      "this process stood still in each of {} tries of a solve; run the same command again to continue", max_tries));
}

// Asks the study's check about an answer that reached its target. Returns false if a stop was requested and the check
// failed.
bool is_checked(const StudyWork& work, std::unique_ptr<ChildProcess>& checker, SolveRecord& record,
                const StopRequested& is_over) {
  try {
    if (work.study.checker && record.status == Status::ok) check_answer(work.study, work.arm, checker, record);
    return true;
  } catch (const ProcessFailure& failure) {
    const std::string why = failure.why + (checker ? checker->end_after(failure.kind) : "");
    if (is_over()) return false;
    throw std::invalid_argument(fmt::format("[check] of {}, run {}, point {}: {}; stored solves are kept", record.label,
                                            record.run, record.point, why));
  }
}

// Returns a drawn order of the solvers. Each second round has the order of the round before, reversed.
std::vector<std::size_t> order_in_round(const Study& study, std::vector<std::size_t> solvers, int round) {
  numerics::Random random(numerics::Key(study.seed).with("order").with(static_cast<std::uint64_t>((round + 1) / 2)));
  for (std::size_t left = solvers.size(); left > 1; --left)
    std::swap(solvers[left - 1], solvers[static_cast<std::size_t>(random.index(static_cast<int>(left)))]);
  if (round % 2 == 0) std::ranges::reverse(solvers);
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

  // Returns the call for a point. A chain continues at `left_arm`.
  SolveRequest call_at(const StudyWork& work, int run, int point, const Configuration& left_arm) {
    if (at_run != run) {
      at_run = run;
      poses = targets_of_run(work.study, work.arm, run);
      own_starts = starts_of_run(work.study, work.arm, run);
    }
    const auto place = static_cast<std::size_t>(point - 1);
    return {poses[place], own_starts.empty() ? left_arm : own_starts[place], run, point};
  }
  // Makes the solvers with these indices, and warms each up with a call of the last unit.
  void prepare(const StudyWork& work, const std::vector<std::size_t>& indices, const std::vector<WorkUnit>& units,
               std::size_t together) {
    const SolveRequest call = call_at(work, units.back().run, units.back().last, work.study.initial);
    for (const std::size_t s : indices) {
      solvers.push_back(work.solve_runners[s].make_solver());
      work.solve_runners[s].warm_up(*solvers.back(), call, std::min(together, units.size()));
    }
  }
};

// The circumstances of solving, the same for all sessions of a run.
struct Execution {
  const StudyWork& work;
  int jobs = 1;
  const std::atomic<bool>* cancelled = nullptr;
  SolveVisitor check = {};  // gets each record before it is passed on; empty: none
  RecordQueue& record_queue;
};

// Makes the solves that some solvers lack of the units. The batches of these solvers have one size. A group is one unit
// or the units of a batch. In a warm study a group has two units, so that a call on the other unit comes between the
// two calls on a target; a program gets only one message for each target, because it makes both calls itself. The
// solvers take turns at being first in a group.
class GroupedWork {
 public:
  GroupedWork(const Execution& execution, const std::vector<std::size_t>& solvers, const std::vector<WorkUnit>& units)
      : execution_(execution),
        work_(execution.work),
        solvers_(solvers),
        units_(units),
        batch_(static_cast<std::size_t>(work_.solve_runners[solvers.front()].batch())),
        is_warm_(work_.study.state == CacheState::warm && batch_ == 0),
        group_size_(std::max<std::size_t>(batch_, is_warm_ ? 2 : 1)),
        states_(static_cast<std::size_t>(execution.jobs)) {
    const std::size_t rest = batch_ > 0 ? group_size_ - 1 : 0;  // the last units are a batch, too
    groups_ = std::max<std::size_t>(1, (units.size() + rest) / group_size_);
  }

  // Records are passed on even if an exception ends the work, such as for a solve that the check refuses.
  void solve() {
    try {
      parallel_for(groups_ * solvers_.size(), execution_.jobs, execution_.cancelled,
                   [this](std::size_t index, std::size_t worker, const StopRequested& is_over) {
                     solve_group(assigned(index, worker, is_over));
                   });
    } catch (...) {
      execution_.record_queue.flush();
      throw;
    }
    execution_.record_queue.flush();
    states_.clear();
    for (const std::size_t s : solvers_) work_.solve_runners[s].end_processes();
  }

 private:
  // The work of one solver on one group.
  struct Assignment {
    WorkerState& state;
    std::size_t solver_index;
    solvers::Solver& solver;
    const SolveRunner& solve_runner;
    std::span<const WorkUnit> units;
    const StopRequested& is_over;
    StopRequested is_cut;  // as is_over; never for a batch, which is stored whole or not at all
  };

  Assignment assigned(std::size_t index, std::size_t worker, const StopRequested& is_over) {
    WorkerState& state = states_[worker];
    if (state.solvers.empty()) state.prepare(work_, solvers_, units_, group_size_);
    const std::size_t group = index / solvers_.size();
    const std::size_t place = (index + group) % solvers_.size();
    const std::size_t first = group * group_size_;
    const std::size_t end = group + 1 == groups_ ? units_.size() : first + group_size_;
    return {.state = state,
            .solver_index = solvers_[place],
            .solver = *state.solvers[place],
            .solve_runner = work_.solve_runners[solvers_[place]],
            .units = std::span(units_).subspan(first, end - first),
            .is_over = is_over,
            .is_cut = batch_ > 0 ? StopRequested([] { return false; }) : is_over};
  }

  void solve_group(const Assignment& assignment) {
    const bool is_warmed_here = is_warm_ && !assignment.solve_runner.is_program();
    if ((is_warmed_here || batch_ > 0) && !make_first_calls(assignment)) return;
    if (batch_ > 0) assignment.solve_runner.count_failure(assignment.solver);
    std::vector<SolveRecord> unchecked;  // checked after the last call, because a check would cool the caches
    for (const WorkUnit& unit : assignment.units) solve_unit(unit, assignment, unchecked);
    for (SolveRecord& record : unchecked) {
      if (!pass_on(record, assignment)) break;
    }
  }

  // Makes the first call on each target of a group, unrecorded: warm ones warm the caches, those of a batch are sent
  // together. Returns false if a stop was requested.
  bool make_first_calls(const Assignment& assignment) {
    const auto calls = [&] {
      for (const WorkUnit& unit : assignment.units) {
        if (assignment.is_cut()) break;
        assignment.solve_runner.warm_call(assignment.solver,
                                          assignment.state.call_at(work_, unit.run, unit.first, work_.study.initial));
      }
      const bool has_succeeded = batch_ == 0 || assignment.solve_runner.send_batch(assignment.solver);
      return SolveRecord{.status = has_succeeded ? Status::ok : Status::crashed};
    };
    return without_suspension(watch_, assignment.is_over, calls).has_value();
  }

  void solve_unit(const WorkUnit& unit, const Assignment& assignment, std::vector<SolveRecord>& unchecked) {
    const auto& [state, s, solver, solve_runner, units, is_over, is_cut] = assignment;
    Configuration left_arm = work_.chain_end(s, unit.run);
    for (int point = work_.next_point(s, unit); point <= unit.last && !is_cut(); ++point) {
      const SolveRequest call = state.call_at(work_, unit.run, point, left_arm);
      const auto solve = [&runner = solve_runner, &of_worker = solver, &call] { return runner.solve(of_worker, call); };
      std::optional<SolveRecord> record = without_suspension(watch_, is_cut, solve);
      if (!record) return;
      if (!is_over()) solve_runner.count_failure(solver);
      if (continues_from(*record, work_.study.start)) left_arm = to_eigen(record->answer_rad);
      if (is_warm_ && work_.study.checker)
        unchecked.push_back(std::move(*record));
      else if (!pass_on(*record, assignment))
        return;
    }
  }

  // Checks a record and passes it on. Returns false if a stop was requested and the study's check failed.
  bool pass_on(SolveRecord& record, const Assignment& assignment) {
    if (!is_checked(work_, assignment.state.checker, record, assignment.is_over)) return false;
    if (execution_.check) execution_.check(record);
    execution_.record_queue.push(std::move(record));
    return true;
  }

  const Execution& execution_;
  const StudyWork& work_;
  const std::vector<std::size_t>& solvers_;  // indices
  const std::vector<WorkUnit>& units_;
  std::size_t batch_;  // problems; 0: one by one
  bool is_warm_;
  std::size_t group_size_;  // units
  std::size_t groups_ = 1;
  SuspensionWatch watch_;
  std::vector<WorkerState> states_;  // by worker
};

// Solves what these solvers lack of the units, first those without batches, then by the size of their batches.
void solve_session(const Execution& execution, const std::vector<std::size_t>& solvers,
                   const std::vector<WorkUnit>& units) {
  std::map<int, std::vector<std::size_t>> by_batch;
  for (const std::size_t s : solvers) by_batch[execution.work.solve_runners[s].batch()].push_back(s);
  for (const auto& [batch, with_batch] : by_batch) GroupedWork(execution, with_batch, units).solve();
}

// The anomalies of programs and users' classes, by label.
using Anomalies = std::map<std::string, std::set<std::string>>;

// Cuts names of extras to what the store takes, and notes the anomalies of a user's class.
void sanitize_record(SolveRecord& record, std::set<std::string>& anomalies) {
  if (record.status == Status::not_finite)
    anomalies.insert("errors or answers are not finite, or do not have one number for each joint");
  if (record.counted_by == CountedBy::none)
    anomalies.insert("it did not ask the objective, so its evaluations are not counted");
  const std::map<std::string, double> extras = std::exchange(record.extras, {});
  for (const auto& [name, value] : extras) {
    const std::string cut(base::front(base::one_line(name), 200));
    if (cut != name) anomalies.insert(fmt::format("names of its extras are cut to {}", base::plain_text));
    record.extras[cut] = value;
  }
}

// Returns sentences on the anomalies of programs and classes, and adds these to the session.
std::vector<std::string> record_anomalies(const StudyWork& work, Anomalies& anomalies, Store& store,
                                          std::int64_t session) {
  std::vector<std::string> sentences;
  for (const SolveRunner& solve_runner : work.solve_runners) {
    if (const std::string of_program = solve_runner.anomalies(); !of_program.empty())
      anomalies[solve_runner.label()].insert(of_program);
  }
  for (const auto& [label, clauses] : anomalies) {
    if (clauses.empty()) continue;
    const std::string joined = fmt::format("{}", fmt::join(clauses, "; "));
    sentences.push_back(fmt::format("{}: {}", label, joined));
    store.add_to_session(session, {{"solver." + label, joined}});
  }
  return sentences;
}

// Adds what is wrong with answers that were made elsewhere, by the key of their series.
void add_answer_facts(const StudyWork& work, std::map<std::string, std::string>& facts) {
  for (std::size_t s = 0; s < work.solve_runners.size(); ++s) {
    const SolverEntry& entry = work.study.solvers[s];
    if (!entry.answers) continue;
    const AnswersReport report = report_on(*entry.answers, work.study, work.arm);
    const std::string& key = work.solve_runners[s].key();
    if (!report.cause.empty()) facts[cause_fact + key] = report.cause;
    if (!report.facts.empty()) facts[answers_fact + key] = report.facts;
  }
}

// Returns all joints of a program's answer; empty if the solve has none. A refused answer is among the extras.
Configuration answer_of_program(const SolveRecord& solve) {
  if (has_no_answer(solve.status) || solve.counted_by == CountedBy::ikbench) return {};
  if (solve.status != Status::refused) return to_eigen(solve.answer_rad);
  Configuration answer(std::ssize(solve.answer_rad));
  for (Eigen::Index j = 0; j < answer.size(); ++j) {
    const auto extra = solve.extras.find(fmt::format("{}{}", refused_prefix, j + 1));
    if (extra == solve.extras.end()) return {};
    answer[j] = extra->second;
  }
  return answer;
}

// Returns why the answers of a program with its own kinematics miss their targets; empty if no cause is known.
std::string cause_of_program(const StudyWork& work, const std::string& key, const Store& store) {
  constexpr std::size_t most = 2000;  // answers that are looked at
  std::vector<AnsweredTarget> answers;
  store.for_each_in_series(key, [&](const SolveRecord& solve) {
    Configuration answer = answers.size() < most ? answer_of_program(solve) : Configuration();
    if (answer.size() == 0 || !answer.allFinite()) return;
    Pose target = Pose::Identity();
    target.translation() = to_eigen(solve.target_position_m);
    target.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(solve.target_rotation.data());
    answers.push_back({target, std::move(answer)});
  });
  const auto diagnosis = diagnose(work.arm, answers, right_within(work.study));
  return diagnosis ? diagnosis_text(*diagnosis) : "";
}

// Adds why programs miss their targets to the session, by the keys of their series.
void record_causes(const StudyWork& work, Store& store, std::int64_t session) {
  if (work.study.search == Search::wrist || work.study.search == Search::flange) return;
  for (std::size_t s = 0; s < work.solve_runners.size(); ++s) {
    if (!work.study.solvers[s].program) continue;
    const std::string& key = work.solve_runners[s].key();
    if (const std::string cause = cause_of_program(work, key, store); !cause.empty())
      store.add_to_session(session, {{cause_fact + key, cause}});
  }
}

// Returns the facts that each session of a run has, by name.
std::map<std::string, std::string> session_facts(const StudyWork& work, const RunRequest& request) {
  std::map<std::string, std::string> facts = environment();
  for (const SolverEntry& entry : work.study.solvers) {
    facts["source." + entry.solver] = source_digest_of(entry);
    if (const std::string library = library_name(entry); !library.empty()) facts["library." + entry.solver] = library;
  }
  for (const SkippedSolver& skipped : work.study.skipped) facts["left_out." + skipped.label] = skipped.reason;
  add_answer_facts(work, facts);
  facts["jobs"] = std::to_string(request.jobs);
  facts["command"] = request.command;
  if (request.shard.count > 1) facts["shard"] = request.shard.text();
  facts["study"] = work.study.name;
  facts["analysis"] = to_json(work.study.plan);  // with the solvers, because the study may be saved with others later
  facts["solvers"] = base::text_of(base::Json(labels_of(work.study)));
  facts["state"] = work.study.is_chained() ? std::string_view("runs in a row") : name_of(work.study.state);
  return facts;
}

// Returns the check of a study's records before they are stored. The check throws std::runtime_error for a record that
// no reader of the store would take.
SolveVisitor check_before_storing(const StoredStudy& stored) {
  return [check = answer_check(stored)](const SolveRecord& record) {
    try {
      check(record);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(fmt::format("{}; it is not stored, because no reader would accept it", error.what()));
    }
  };
}

void solve_missing(StudyWork& work, const StoredStudy& stored, Store& store, const RunRequest& request,
                   Progress& progress) {
  std::map<std::string, std::string> facts = session_facts(work, request);
  Anomalies anomalies;
  for (const SolverEntry& entry : work.study.solvers) {
    if (entry.custom) anomalies[entry.label];
  }
  std::int64_t session = 0;
  const auto store_records = [&](std::vector<SolveRecord>& records) {
    for (SolveRecord& record : records) {
      record.session = session;
      const auto of_class = anomalies.find(record.label);
      if (of_class != anomalies.end()) sanitize_record(record, of_class->second);
    }
    store.append(records);
    for (std::size_t i = 0; i < records.size(); ++i) {
      ++progress.done;
      if (request.progress) request.progress(progress);
    }
  };
  RecordQueue record_queue(store_records, request.flush_interval);
  const Execution execution{.work = work,
                            .jobs = request.jobs,
                            .cancelled = request.cancelled,
                            .check = check_before_storing(stored),
                            .record_queue = record_queue};
  for (int round = 1; round <= work.rounds(); ++round) {
    if (work.rounds() > 1) facts["round"] = fmt::format("{}/{}", round, work.rounds());
    for (const auto& [lacking, units] : work.sessions_of(round)) {
      if (request.cancelled != nullptr && *request.cancelled) break;
      session = store.begin_session(facts);
      solve_session(execution, order_in_round(work.study, lacking, round), units);
    }
  }
  progress.anomalies = record_anomalies(work, anomalies, store, session);
  record_causes(work, store, session);
}

// Throws std::invalid_argument if the store now has a study of that name that is not `ours`.
void refuse_another(const StoredStudy& ours, const StoredStudy& now) {
  if (ours.definition.json == now.definition.json &&
      std::ranges::equal(ours.series, now.series, {}, &Series::key, &Series::key))
    return;
  throw std::invalid_argument(fmt::format(
      "another ikbench has meanwhile saved a different study named '{}' in this store; no solve is lost; give the other "
      "study another name or --out, then run this study again for its report",
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
  progress.reused = move_past_stored(work, store);
  progress.done = progress.reused;
  if (request.progress) request.progress(progress);
  if (progress.done < progress.total) solve_missing(work, stored, store, request, progress);
  if (progress.done < progress.total) return progress;
  refuse_another(stored, store.study(study.name));
  count_answers(study, stored, store, request.jobs, request.cancelled);
  return progress;
}

void solve_without_store(const Study& study, int jobs, const std::function<void(SolveRecord)>& take,
                         const std::atomic<bool>* cancelled) {
  const StudyWork work(study, series_of(study), jobs);
  RecordQueue record_queue([&](std::vector<SolveRecord>& records) {
    for (SolveRecord& record : records) take(std::move(record));
  });
  std::vector<std::size_t> indices(study.solvers.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  solve_session({.work = work, .jobs = jobs, .cancelled = cancelled, .record_queue = record_queue}, indices,
                work.units_in({}));
}

bool continues_from(const SolveRecord& solve, Start start) {
  return start == Start::previous && solve.status != Status::not_finite;
}

SolveRecord solve_once(const Study& study, const SolverEntry& entry, const Pose& target) {
  const Robot arm = robot_of(study);
  const SolveRunner solve_runner(study, entry, series_key(study, entry), arm);
  const std::unique_ptr<solvers::Solver> solver = solve_runner.make_solver();
  const SolveRequest call{target, study.initial, 1, 1};
  if (solve_runner.batch() > 0) {
    solve_runner.warm_call(*solver, call);
    solve_runner.send_batch(*solver);
  }
  return solve_runner.solve(*solver, call);
}

}  // namespace ikbench::experiments
