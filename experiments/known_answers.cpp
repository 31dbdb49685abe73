#include "experiments/known_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <thread>
#include <tuple>
#include <utility>

#include "base/csv.hpp"
#include "base/number.hpp"
#include "experiments/runner.hpp"
#include "experiments/stored_checks.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/task.hpp"
#include "experiments/verifier.hpp"
#include "results/goal_freedoms.hpp"
#include "solvers/damped_step.hpp"
#include "solvers/objective.hpp"

namespace ikbench::experiments {

using namespace results;
using robots::whole_turn;

namespace {

constexpr double angle_apart = 1e-3, distance_apart = 1e-6;  // [rad], [m] between different answers
constexpr double min_singular_value = 1e-4;                  // smallest singular value [m, rad] of a regular answer
constexpr double rounding_of_limits = 1e-9;                  // [rad, m]

// Targets that are known, of a study that solves them again.
class KnownTargets final : public TargetSet {
 public:
  explicit KnownTargets(std::vector<Pose> poses) : poses_(std::move(poses)) {}

  std::string_view name() const override { return "poses"; }
  std::string_view summary() const override { return ""; }
  void list_fields(Fields&) override {}
  int points() const override { return static_cast<int>(poses_.size()); }
  std::vector<Pose> poses(const Robot&, Random&) const override { return poses_; }

 private:
  std::vector<Pose> poses_;
};

// Returns the entry whose restarts make known answers.
SolverEntry restarting_entry() { return {.label = "restarts", .solver = "levenberg_marquardt"}; }

// Returns the study that makes the restarts to these targets: a run for each start, drawn at random.
Study restarts_study(const Study& study, std::vector<Pose> targets) {
  Study restarts = study;
  restarts.path = std::make_shared<KnownTargets>(std::move(targets));
  restarts.solvers = {restarting_entry()};
  restarts.runs = restarts_per_target;
  restarts.rounds = 1;
  restarts.start = Start::random;
  restarts.wrap = WrapPolicy::no;
  restarts.state = CacheState::first;
  restarts.trace = solvers::Trace::none;
  restarts.checker = nullptr;
  restarts.check = {};
  restarts.loop = {};
  restarts.stop.seconds = 0;
  restarts.stop.evaluations = 1000;
  restarts.stop.iterations = 1000;
  return restarts;
}

// Returns the rows of a list of answers [rad, m].
std::vector<Configuration> rows_of(const std::vector<double>& list, Eigen::Index joints) {
  std::vector<Configuration> rows;
  for (std::size_t i = 0; i + static_cast<std::size_t>(joints) <= list.size(); i += static_cast<std::size_t>(joints))
    rows.emplace_back(Eigen::Map<const Eigen::VectorXd>(list.data() + i, joints));
  return rows;
}

// The answers of one solve.
struct SolverAnswers {
  std::string series;
  int run = 1;
  std::vector<Configuration> answers;
};
// A target with all that was answered.
struct CountedTarget {
  Pose pose;
  std::vector<SolverAnswers> given = {};
  bool has_restarts = false;  // also if none of them reached the target
  std::vector<double> restarts_rad = {};
};
using CountedTargets = std::map<std::pair<int, int>, CountedTarget>;  // by run (1 if all runs have it) and point

// Returns the place of a solve's target among the study's targets, from 0.
int index_of_target(const Study& study, int run, int point) {
  return study.path->is_random() ? (run - 1) * study.path->points() + point - 1 : point - 1;
}

// Reads the answers to a study's first targets. Without targets if no solver gave several answers.
CountedTargets targets_of(const Study& study, const StoredStudy& stored, const Store& store, Eigen::Index joints) {
  CountedTargets targets;
  bool has_several = false;
  store.for_each_in_study(stored, [&](const SolveRecord& solve) {
    if (index_of_target(study, solve.run, solve.point) >= max_counted_targets) return;
    const std::pair place(study.path->is_random() ? solve.run : 1, solve.point);
    CountedTarget& target = targets.try_emplace(place, CountedTarget{target_of(solve)}).first->second;
    SolverAnswers& given =
        target.given.emplace_back(SolverAnswers{.series = solve.series, .run = solve.run, .answers = {}});
    has_several |= !solve.all_answers_rad.empty();
    if (!solve.all_answers_rad.empty())
      given.answers = rows_of(solve.all_answers_rad, joints);
    else if (!arm_stays(solve.status))
      given.answers = rows_of(solve.answer_rad, joints);
  });
  if (!has_several) targets.clear();
  return targets;
}

// Makes the restarts of all targets if any target has none. They are made for all of the study's first targets, so that
// the starts do not depend on which solves are there. Returns false if the request was cancelled.
bool make_restarts(const Study& study, CountedTargets& targets, int jobs, const std::atomic<bool>* cancelled) {
  const auto has_restarts = [](const auto& target) { return target.second.has_restarts; };
  if (std::ranges::all_of(targets, has_restarts)) return true;
  const Robot arm = robot_of(study);
  std::vector<Pose> poses;
  std::vector<CountedTarget*> by_index;  // null: not among the targets
  const int runs = study.path->is_random() ? study.runs : 1;
  for (int run = 1; run <= runs && std::ssize(poses) < max_counted_targets; ++run) {
    int point = 0;
    for (const Pose& pose : targets_of_run(study, arm, run)) {
      if (std::ssize(poses) == max_counted_targets) break;
      poses.push_back(pose);
      const auto target = targets.find({run, ++point});
      by_index.push_back(target == targets.end() ? nullptr : &target->second);
    }
  }
  std::vector<std::map<int, std::vector<double>>> answers(poses.size());  // by run, since several jobs end in any order
  solve_without_store(
      restarts_study(study, poses), jobs,
      [&](const SolveRecord& solve) {
        if (solve.status == Status::ok || solve.status == Status::limit_violated)
          answers[static_cast<std::size_t>(solve.point - 1)][solve.run] = solve.answer_rad;
      },
      cancelled);
  for (std::size_t i = 0; i < by_index.size(); ++i) {
    if (by_index[i] == nullptr) continue;
    std::vector<double>& restarts = by_index[i]->restarts_rad;
    restarts.clear();
    for (const auto& [run, answer] : answers[i]) restarts.insert(restarts.end(), answer.begin(), answer.end());
  }
  return cancelled == nullptr || !*cancelled;
}

// Counts the answers of a solver, which become known to the finder.
AnswerCount count_of(const SolverAnswers& given, AnswerFinder& finder) {
  AnswerCount count{.series = given.series, .run = given.run, .given = static_cast<int>(given.answers.size())};
  std::vector<std::size_t> found;
  for (const Configuration& answer : given.answers) {
    if (!finder.is_true(answer)) {
      ++count.wrong;
      continue;
    }
    const std::optional<std::size_t> index = finder.add(answer);
    if (!index) continue;
    if (std::ranges::find(found, *index) != found.end())
      ++count.doubled;
    else
      found.push_back(*index);
  }
  count.found = static_cast<int>(found.size());
  return count;
}

// Makes the restarts that the targets lack, and counts all answers. Returns nullopt if the request was cancelled.
std::optional<CountedAnswers> counts_of(const Study& study, const Robot& arm, CountedTargets targets, int jobs,
                                        const std::atomic<bool>* cancelled) {
  CountedAnswers counted{.restarts_key = series_key(study, restarting_entry())};
  if (!make_restarts(study, targets, jobs, cancelled)) return std::nullopt;
  for (const auto& [place, target] : targets) {
    if (cancelled != nullptr && *cancelled) return std::nullopt;
    AnswerFinder finder(study, arm, target.pose);
    for (const Configuration& answer : rows_of(target.restarts_rad, arm.joints()))
      if (finder.is_true(answer)) finder.add(answer);
    for (const SolverAnswers& given : target.given) {
      counted.counts.push_back(count_of(given, finder));
      counted.counts.back().point = place.second;
    }
    counted.targets.push_back({.run = place.first,
                               .point = place.second,
                               .known = finder.is_continuum() ? 0 : static_cast<int>(finder.known().size()),
                               .is_continuum = finder.is_continuum(),
                               .restarts_rad = target.restarts_rad});
  }
  std::ranges::sort(counted.counts, {},
                    [](const AnswerCount& each) { return std::tuple(each.series, each.run, each.point); });
  return counted;
}

}  // namespace

std::string why_not_countable(const Study& study, const Robot& arm) {
  const auto freedoms = static_cast<int>(goal_freedoms(study.search));
  if (freedoms == 0) return fmt::format("search = \"{}\" does not search all joints", name_of(study.search));
  if (arm.joints() > freedoms)
    return fmt::format("{} joints for {} freedoms: infinitely many answers", arm.joints(), freedoms);
  if (arm.joints() < freedoms)
    return fmt::format("{} joints for {} freedoms: most targets have no answer", arm.joints(), freedoms);
  if (!study.has_tolerance()) return "the study has no tolerance";
  return "";
}

AnswerFinder::AnswerFinder(const Study& study, const Robot& arm, const Pose& target)
    : study_(study), arm_(arm), target_(target), task_(study, arm) {}

Configuration AnswerFinder::turned(Configuration answer) const {
  for (Eigen::Index j = 0; j < answer.size(); ++j) {
    const double lower = arm_.limits.lower[j], upper = arm_.limits.upper[j];
    if (arm_.chain.slides(j) || robots::is_endless(lower, upper) || !std::isfinite(answer[j])) continue;
    if (answer[j] < lower - rounding_of_limits)
      answer[j] += whole_turn * std::ceil((lower - rounding_of_limits - answer[j]) / whole_turn);
    if (answer[j] > upper + rounding_of_limits)
      answer[j] -= whole_turn * std::ceil((answer[j] - upper - rounding_of_limits) / whole_turn);
  }
  return answer;
}

bool AnswerFinder::is_true(const Configuration& answer) const {
  if (!answer.allFinite()) return false;
  const Verification verified = verify(
      arm_, {.target = target_, .start = answer, .answer = answer, .is_axis_free = study_.search == Search::axis});
  constexpr double rounding = 1e-9;
  return study_.stop.is_met(verified.position_error, verified.angle, rounding);
}

bool AnswerFinder::is_inside(const Configuration& answer) const {
  return study_.limits == LimitPolicy::recorded || arm_.limits.violation(answer) <= rounding_of_limits;
}

Configuration AnswerFinder::polished(const Configuration& answer) const {
  constexpr int max_steps = 30;
  constexpr double smallest_share = 1e-6;
  solvers::Objective objective(task_.arm(), task_.goal(target_));
  Eigen::MatrixXd jacobian(objective.rows(), answer.size());
  Configuration best = answer;
  for (int step = 0; step < max_steps; ++step) {
    const solvers::Linearized linearized = objective.linearize(best, jacobian);
    const Configuration newton = solvers::pseudo_inverse_times(jacobian, linearized.to_go, 0);
    double share = 1;  // a whole step overshoots near a singular answer
    while (share > smallest_share && !(objective.error(best + share * newton) < linearized.error)) share /= 2;
    if (share <= smallest_share) break;
    best += share * newton;
  }
  return best;
}

bool AnswerFinder::is_singular(const Configuration& exact) const {
  solvers::Objective objective(task_.arm(), task_.goal(target_));
  Eigen::MatrixXd jacobian(objective.rows(), exact.size());
  objective.linearize(exact, jacobian);
  if (objective.goal().has_direction()) jacobian.bottomRows(3) /= objective.goal().rotation_weight;
  double rank = 0;  // J^+ J without the singular values that are too small has as many ones on its diagonal as are left
  for (Eigen::Index j = 0; j < exact.size(); ++j)
    rank += solvers::pseudo_inverse_times(jacobian, jacobian.col(j), min_singular_value)[j];
  return rank < static_cast<double>(exact.size()) - 0.5;
}

std::optional<std::size_t> AnswerFinder::add(const Configuration& answer) {
  constexpr std::size_t most_of_continuum = 200;
  if (is_continuum_ && known_.size() >= most_of_continuum) return known_.size() + beyond_++;
  const Configuration exact = turned(polished(answer));
  if (!is_inside(exact)) return std::nullopt;
  const auto is_same = [&](const Configuration& known) {
    for (Eigen::Index j = 0; j < exact.size(); ++j) {
      const bool slides = arm_.chain.slides(j);
      const double apart = slides ? exact[j] - known[j] : std::remainder(exact[j] - known[j], whole_turn);
      if (std::abs(apart) > (slides ? distance_apart : angle_apart)) return false;
    }
    return true;
  };
  const auto known = std::ranges::find_if(known_, is_same);
  const auto index = static_cast<std::size_t>(known - known_.begin());
  if (known == known_.end()) {
    known_.push_back(exact);
    is_continuum_ = is_continuum_ || is_singular(exact);
  }
  return index;
}

void count_answers(const Study& study, const StoredStudy& stored, Store& store, int jobs,
                   const std::atomic<bool>* cancelled) {
  const Robot arm = robot_of(study);
  if (stored.definition.is_grid()) return;  // a map shows no counts
  const auto may_give_several = [](const SolverEntry& entry) { return entry.program || entry.answers; };
  CountedAnswers earlier = store.counted_answers(stored.name);
  CountedTargets targets;
  if (std::ranges::any_of(study.solvers, may_give_several) && why_not_countable(study, arm).empty())
    targets = targets_of(study, stored, store, arm.joints());
  if (targets.empty()) {
    if (!earlier.targets.empty()) store.save_counted_answers(stored.name, {});  // of solvers that are gone
    return;
  }
  if (earlier.restarts_key == series_key(study, restarting_entry()))
    for (KnownAnswers& known : earlier.targets)
      if (const auto target = targets.find({known.run, known.point}); target != targets.end()) {
        target->second.has_restarts = true;
        target->second.restarts_rad = std::move(known.restarts_rad);
      }
  if (const auto counted = counts_of(study, arm, std::move(targets), jobs, cancelled))
    store.save_counted_answers(stored.name, *counted);
}

std::optional<CountedAnswers> recounted_answers(const StoredStudy& stored, const Store& store) {
  Study study = study_in_store(stored);
  const std::string restarts_key = store.counted_answers(stored.name).restarts_key;
  const bool has_this_source = restarts_key.find(source_key(restarting_entry())) != std::string::npos;
  if (!has_this_source || !read_stored_targets(stored, study)) return std::nullopt;
  const Robot arm = robot_of(study);
  const auto jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::optional<CountedAnswers> counted =
      counts_of(study, arm, targets_of(study, stored, store, arm.joints()), jobs, nullptr);
  counted->restarts_key = restarts_key;  // a study read from its store has other fields that change no answer
  return counted;
}

void write_answers(const Store& store, const StoredStudy& stored, const base::Write& write) {
  const SolveVisitor check = stored_solve_check(stored);
  const Study study = study_in_store(stored);
  const Robot arm = robot_of(study);
  std::string text = "run,point,label,number";
  for (int j = 1; j <= arm.joints(); ++j) text += fmt::format(",q{}", j);
  text += ",true\n";
  store.for_each_in_study(stored, [&](const SolveRecord& solve) {
    check(solve);
    const bool is_single = solve.all_answers_rad.empty();
    if (is_single && arm_stays(solve.status)) return;
    const Pose target = target_of(solve);
    const AnswerFinder finder(study, arm, target);
    int number = 0;
    for (const Configuration& answer : rows_of(is_single ? solve.answer_rad : solve.all_answers_rad, arm.joints())) {
      text += fmt::format("{},{},", solve.run, solve.point);
      base::append_csv_cell(text, solve.label);
      text += fmt::format(",{}", ++number);
      for (const double value : answer) {
        text += ',';
        base::append(text, value);
      }
      text += finder.is_true(answer) ? ",yes\n" : ",no\n";
    }
    constexpr std::size_t part = 1 << 20;  // bytes that are written at a time
    if (text.size() < part) return;
    write(text);
    text.clear();
  });
  write(text);
}

}  // namespace ikbench::experiments
