#include "experiments/runner.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <time.h>

#include <array>
#include <chrono>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "experiments/environment.hpp"
#include "experiments/study_file.hpp"
#include "experiments/verifier.hpp"
#include "robots/spherical_wrist.hpp"
#include "robots/units.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

StopReason recorded(Stopped stopped) {
  switch (stopped) {
    case Stopped::iterations:
      return StopReason::iterations;
    case Stopped::tolerance:
      return StopReason::tolerance;
    case Stopped::evaluations:
      return StopReason::evaluations;
    case Stopped::time:
      return StopReason::time;
    case Stopped::not_finite:
      break;
  }
  return StopReason::not_finite;
}

std::vector<double> to_vector(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

Eigen::VectorXd to_eigen(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// What is searched for one target: all joints, or those before the wrist.
class Task {
 public:
  Task(const Study& study, const Robot& arm) : study_(study), arm_(arm) {
    if (study.search == Search::wrist) wrist_.emplace(arm.chain);
  }

  const Chain& chain() const { return wrist_ ? wrist_->arm() : arm_.chain; }

  Eigen::Vector3d goal(const Pose& target) const { return wrist_ ? wrist_->centre(target) : target.translation(); }

  Problem problem(const Eigen::VectorXd& start) const {
    const int joints = chain().joints();
    return {.start = start.head(joints),
            .lower = arm_.limits.lower.head(joints),
            .upper = arm_.limits.upper.head(joints),
            .population = study_.population,
            .iterations = study_.stop.iterations};
  }

  // All joints of the answer: those searched, and the wrist's by the closed form.
  Eigen::VectorXd completed(const Eigen::VectorXd& found, const Pose& target, const Eigen::VectorXd& start) const {
    if (!wrist_) return found;
    const Eigen::Vector3d near = start.tail<3>();
    const std::array<Eigen::Vector3d, 2> branches = wrist_->angles(found, target.linear(), near);
    Eigen::VectorXd answer(found.size() + 3);
    answer << found, branches[chosen(branches, near)];
    return answer;
  }

 private:
  std::size_t chosen(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const {
    const std::size_t nearer = (branches[0] - near).norm() <= (branches[1] - near).norm() ? 0 : 1;
    const auto is_inside = [&](const Eigen::Vector3d& angles) {
      return (angles.array() >= arm_.limits.lower.tail<3>().array()).all() &&
             (angles.array() <= arm_.limits.upper.tail<3>().array()).all();
    };
    switch (study_.wrist_branch) {
      case WristBranch::positive:
        return 0;
      case WristBranch::negative:
        return 1;
      case WristBranch::inside:
        return !is_inside(branches[nearer]) && is_inside(branches[1 - nearer]) ? 1 - nearer : nearer;
      case WristBranch::nearest:
        break;
    }
    return nearer;
  }

  const Study& study_;
  const Robot& arm_;
  std::optional<SphericalWrist> wrist_;
};

// One entrant of a study, ready to solve any of its points.
class Contest {
 public:
  Contest(const Study& study, const Entrant& entrant, const Robot& arm)
      : study_(study),
        entrant_(entrant),
        arm_(arm),
        task_(study, arm),
        info_(solver(entrant.solver)),
        options_(effective_options(study, entrant)),
        series_{.key = series_key(study, entrant),
                .label = entrant.label,
                .algorithm = entrant.solver,
                .options = nlohmann::json(options_).dump()} {}

  const Series& series() const { return series_; }

  SolveRecord solve(const Pose& target, const Eigen::VectorXd& start, int run, int point) const {
    const std::unique_ptr<Solver> solver = info_.make(options_);
    Objective objective(task_.chain(), task_.goal(target));
    Random random(Key(study_.seed)
                      .with(entrant_.label)
                      .with(static_cast<std::uint64_t>(run))
                      .with(static_cast<std::uint64_t>(point)));
    const Problem problem = task_.problem(start);

    const double thread_started = thread_seconds();
    const auto started = std::chrono::steady_clock::now();
    const Solution solution = ikbench::solve(*solver, problem, objective, random, study_.stop, study_.trace);
    const Eigen::VectorXd answer = task_.completed(solution.best.q, target, start);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
    const double cpu_seconds = thread_seconds() - thread_started;

    const Verdict verdict = verify(arm_, target, start, answer);
    SolveRecord record{.study = study_.name,
                       .robot = arm_.name,
                       .solver = entrant_.label,
                       .series = series_.key,
                       .run = run,
                       .point = point,
                       .target_position_m = to_vector(target.translation()),
                       .target_rotation = by_rows(target.linear()),
                       .start_rad = to_vector(start),
                       .answer_rad = to_vector(answer),
                       .reached_position_m = to_vector(verdict.reached),
                       .position_error_cm = verdict.position_error / centimetre,
                       .claimed_error_cm = solution.best.error / centimetre,
                       .orientation_error = verdict.orientation_error,
                       .variation_deg = verdict.variation / degree,
                       .largest_move_deg = verdict.largest_move / degree,
                       .limit_violation_deg = verdict.limit_violation / degree,
                       .evaluations = solution.evaluations,
                       .iterations = solution.iterations,
                       .stop_reason = recorded(solution.stopped),
                       .seconds = seconds.count(),
                       .cpu_seconds = cpu_seconds,
                       .timing = is_debug_build() ? Timing::debug_build : Timing::clean};
    record.status = record.stop_reason == StopReason::not_finite
                        ? Status::not_finite
                        : judge(verdict, {.claimed_error = solution.best.error,
                                          .tolerance = study_.stop.tolerance,
                                          .orientation_is_exact = study_.search == Search::wrist});
    for (const double error : solution.trace) record.trace_cm.push_back(error / centimetre);
    return record;
  }

 private:
  const Study& study_;
  const Entrant& entrant_;
  const Robot& arm_;
  Task task_;
  SolverInfo info_;
  Settings options_;
  Series series_;
};

// The arm is where the answer put it, unless that was no configuration at all.
void move(Eigen::VectorXd& configuration, const SolveRecord& record) {
  if (record.status != Status::not_finite) configuration = to_eigen(record.answer_rad);
}

struct Chained {  // one run of one entrant, and what the store already has of it
  const Contest* contest;
  int run;
  int first_missing = 1;
  Eigen::VectorXd start;
};

StudyEntry entry_of(const Study& study, const std::vector<Contest>& contests) {
  StudyEntry entry{.name = study.name, .definition = to_json(study), .series = {}};
  for (const Contest& contest : contests) entry.series.push_back(contest.series());
  return entry;
}

}  // namespace

Progress run(const Study& study, Store& store, const RunRequest& request) {
  const Robot arm = robot(study.robot);
  const std::vector<Pose> poses = targets(study.path);
  std::vector<Contest> contests;
  for (const Entrant& entrant : study.solvers) contests.emplace_back(study, entrant, arm);
  store.save_study(entry_of(study, contests));

  // Runs outside, solvers inside: whatever drifts on the machine meanwhile touches all solvers alike.
  Progress progress{.total = static_cast<std::int64_t>(contests.size()) * study.runs *
                             static_cast<std::int64_t>(poses.size())};
  std::vector<Chained> work(contests.size() * static_cast<std::size_t>(study.runs));
  for (std::size_t c = 0; c < contests.size(); ++c) {
    for (int run = 1; run <= study.runs; ++run) {
      work[static_cast<std::size_t>(run - 1) * contests.size() + c] = {&contests[c], run, 1, study.initial};
    }
    for (const SolveRecord& record : store.series(contests[c].series().key)) {
      if (record.run > study.runs) continue;
      const auto edited = [&](std::string_view what) {
        return std::invalid_argument(
            fmt::format("the store's solve of run {}, point {} by {} {}; it was edited: take another --out", record.run,
                        record.point, record.solver, what));
      };
      if (record.run < 1) throw edited("has a run below 1");
      if (record.point > static_cast<int>(poses.size()))
        throw edited(fmt::format("is beyond the {} points", poses.size()));
      if (record.answer_rad.size() != static_cast<std::size_t>(study.initial.size())) {
        throw edited(fmt::format("has {} joints instead of {}", record.answer_rad.size(), study.initial.size()));
      }
      if (record.status != Status::not_finite && !to_eigen(record.answer_rad).allFinite()) {
        throw edited("has an answer that is not finite");
      }
      Chained& chained = work[static_cast<std::size_t>(record.run - 1) * contests.size() + c];
      if (record.point != chained.first_missing) {
        throw edited(fmt::format("is there, but not that of point {}", chained.first_missing));
      }
      ++chained.first_missing;
      move(chained.start, record);
      ++progress.reused;
    }
  }
  progress.done = progress.reused;
  if (request.progress) request.progress(progress);
  if (progress.done == progress.total) return progress;

  std::map<std::string, std::string> session = environment();
  session["jobs"] = std::to_string(request.jobs);
  session["command"] = request.command;
  const std::int64_t session_id = store.begin_session(session);
  std::mutex desk;  // where work is taken and records are handed in
  std::size_t next = 0;
  const auto is_cancelled = [&] { return request.cancelled != nullptr && *request.cancelled; };

  const auto take = [&]() -> Chained* {
    const std::scoped_lock lock(desk);
    return next < work.size() ? &work[next++] : nullptr;
  };
  const auto hand_in = [&](SolveRecord record) {
    const std::scoped_lock lock(desk);
    record.session = session_id;
    store.append({record});
    ++progress.done;
    if (request.progress) request.progress(progress);
  };
  const auto work_on = [&](Chained& chained) {
    for (int point = chained.first_missing; point <= static_cast<int>(poses.size()) && !is_cancelled(); ++point) {
      SolveRecord record =
          chained.contest->solve(poses[static_cast<std::size_t>(point - 1)], chained.start, chained.run, point);
      if (request.jobs > 1 && record.timing == Timing::clean) record.timing = Timing::parallel;
      move(chained.start, record);
      hand_in(std::move(record));
    }
  };
  const auto worker = [&](int) {
    while (Chained* chained = take()) work_on(*chained);
  };
  if (request.jobs == 1) {
    worker(0);
  } else {
    // Else oneTBB has no more threads than processors, whatever is asked for.
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(request.jobs));
    tbb::task_arena(request.jobs).execute([&] { tbb::parallel_for(0, request.jobs, worker); });
  }
  return progress;
}

SolveRecord solve_once(const Study& study, const Entrant& entrant, const Pose& target) {
  const Robot arm = robot(study.robot);
  return Contest(study, entrant, arm).solve(target, study.initial, 1, 1);
}

}  // namespace ikbench
