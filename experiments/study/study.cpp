#include "experiments/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "experiments/external/program.hpp"
#include "robots/spherical_wrist.hpp"

namespace ikbench::experiments {

using namespace robots;
using namespace solvers;

namespace {

// Returns the random numbers of a run's targets. NumPy has one sequence for all runs, so a run begins where the numbers
// of the runs before end.
Random random_of_targets(const Study& study, const Robot& arm, int run) {
  if (study.path->uses_numpy_random())
    return Random::of_numpy(
        static_cast<std::uint32_t>(study.seed),
        static_cast<std::uint64_t>(run - 1) * static_cast<std::uint64_t>(study.path->points() * arm.joints()));
  return Random(Key(study.seed).with("targets").with(static_cast<std::uint64_t>(run)));
}

constexpr int max_shards = 100'000;

}  // namespace

std::vector<std::string> labels_of(const Study& study) {
  std::vector<std::string> labels;
  for (const SolverEntry& entry : study.solvers) labels.push_back(entry.label);
  return labels;
}

std::vector<std::string> labels_in_file(const Study& study) {
  std::vector<std::string> labels = labels_of(study);
  for (const AwaitedSolver& awaited : study.awaited) labels.push_back(awaited.label);
  return labels;
}

GoalKind goal_kind(Search search) {
  switch (search) {
    case Search::pose:
      return GoalKind::pose;
    case Search::axis:
      return GoalKind::axis;
    case Search::wrist:
    case Search::all_joints:
    case Search::flange:
      break;
  }
  return GoalKind::position;
}

Robot robot_of(const Study& study) { return study.robot_of_file ? *study.robot_of_file : robot(study.robot); }

Configuration joint_units(const Chain& arm) {
  Configuration units = Configuration::Constant(arm.joints(), base::degree);
  for (Eigen::Index j = 0; j < units.size(); ++j) {
    if (arm.slides(j)) units[j] = 1;
  }
  return units;
}

const SolverInfo& solver_info(const SolverEntry& entry) {
  static const SolverInfo of_answers{.name = std::string(elsewhere),
                                     .summary = "answers that were made elsewhere",
                                     .source = "",
                                     .is_counted = false,
                                     .why_not = [](const Chain&, GoalKind) { return std::string(); },
                                     .make = {},
                                     .describe =
                                         [](const std::function<void(OptionList&)>& visit) {
                                           OptionList none;
                                           visit(none);
                                         }};
  if (entry.answers) return of_answers;
  return entry.custom ? *entry.custom : solver(entry.solver);
}

Settings entry_options(const SolverEntry& entry, const Settings& settings) {
  return entry.program ? resolved_options(entry.program->hello, settings) : solver_info(entry).options(settings);
}

Settings effective_options(const Study& study, const SolverEntry& entry) {
  if (entry.program) return entry_options(entry, entry.options);
  const SolverInfo& info = solver_info(entry);
  Settings settings;
  const Settings presets = info.options({});
  if (const auto preset = presets.find("bounds"); preset != presets.end()) {
    if (study.bounds == BoundsPolicy::initial) settings["bounds"] = "initial";
    if (study.bounds == BoundsPolicy::clamp ||
        (study.limits == LimitPolicy::enforced && preset->second == Setting("initial")))
      settings["bounds"] = "clamp";
  }
  for (const auto& [name, value] : entry.options) settings[name] = value;
  return info.options(settings);
}

int effective_population(const Study& study, const SolverEntry& entry) {
  return entry.population > 0 ? entry.population : study.population;
}

std::vector<Pose> targets_of_run(const Study& study, const Robot& arm, int run) {
  Random random = random_of_targets(study, arm, run);
  return study.path->poses(arm, random);
}

std::vector<Pose> targets_of_run(const Study& study, int run) { return targets_of_run(study, robot_of(study), run); }

Configuration default_configuration(const Robot& arm) {
  return arm.limits.lower.cwiseMax(Configuration::Zero(arm.joints())).cwiseMin(arm.limits.upper);
}

std::vector<Configuration> starts_of_run(const Study& study, const Robot& arm, int run) {
  if (study.start == Start::previous || study.start == Start::initial) return {};
  const Configuration zeros = Configuration::Zero(arm.joints());
  const JointLimits range = arm.limits.around(zeros);
  Random random(Key(study.seed).with("starts").with(static_cast<std::uint64_t>(run)));
  std::vector<Configuration> starts(static_cast<std::size_t>(study.path->points()), (range.lower + range.upper) / 2);
  if (study.start == Start::near) {
    Random of_targets = random_of_targets(study, arm, run);
    starts = study.path->source_configurations(arm, of_targets);
  }
  for (Configuration& start : starts) {
    for (Eigen::Index j = 0; j < start.size(); ++j) {
      if (study.start == Start::random) start[j] = random.uniform(range.lower[j], range.upper[j]);
      if (study.start == Start::near && !arm.chain.slides(j)) {
        const double moved = start[j] + random.uniform(-study.near, study.near);
        start[j] = std::clamp(moved, arm.limits.lower[j], arm.limits.upper[j]);
      }
    }
  }
  return starts;
}

std::vector<UnreachableTarget> unreachable_targets(const Study& study) {
  if (study.path->is_random() || study.path->grid() != nullptr) return {};
  const Robot arm = robot_of(study);
  const std::optional<SphericalWrist> wrist =
      study.search == Search::wrist ? std::optional<SphericalWrist>(arm.chain) : std::nullopt;
  const Chain& searched = wrist ? wrist->arm() : arm.chain;
  const Chain::Ball ball = searched.reach();
  std::vector<UnreachableTarget> unreachable;
  int point = 0;
  for (const Pose& target : targets_of_run(study, arm, 1)) {
    ++point;
    const Eigen::Vector3d goal = wrist ? wrist->centre(target) : target.translation();
    const double distance = (goal - ball.centre).norm();
    if (distance > ball.radius) unreachable.push_back({point, distance, ball.radius});
  }
  return unreachable;
}

Shard parse_shard(std::string_view text) {
  Shard shard;
  std::sscanf(std::string(text).c_str(), "%6d/%6d", &shard.index, &shard.count);
  if (shard.text() == text && shard.index >= 1 && shard.index <= shard.count && shard.count <= max_shards) return shard;
  throw std::invalid_argument(fmt::format("'{}' is not a shard; expected I/N with 1 <= I <= N <= {}, such as 3/12",
                                          text.substr(0, 100), max_shards));
}

std::string Shard::text() const { return fmt::format("{}/{}", index, count); }

bool is_in_shard(Shard shard, const Study& study, int run, int point) {
  const std::int64_t unit =  // from 0; all points of a chain are one unit
      study.is_chained() ? run - 1 : std::int64_t{run - 1} * study.path->points() + point - 1;
  return unit % shard.count == shard.index - 1;
}

std::int64_t work_unit_count(const Study& study) {
  return study.is_chained() ? study.runs : std::int64_t{study.runs} * study.path->points();
}

std::int64_t planned_solve_count(Shard shard, const Study& study) {
  const std::int64_t units = (work_unit_count(study) + shard.count - shard.index) / shard.count;
  return units * (study.is_chained() ? study.path->points() : 1) * std::ssize(study.solvers);
}

}  // namespace ikbench::experiments
