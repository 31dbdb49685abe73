#include "experiments/study.hpp"

#include <fmt/format.h>

#include <optional>

#include "experiments/source_digest.hpp"
#include "results/record.hpp"
#include "robots/spherical_wrist.hpp"
#include "numerics/units.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

template <class Values>
std::string exact(const Values& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{} ", value);
  return text;
}

}  // namespace

Settings effective_options(const Study& study, const Entrant& entrant) {
  const SolverInfo info = solver(entrant.solver);
  Settings settings;
  const bool is_clamped = study.bounds == StudyBounds::clamp || study.limits == Limits::enforced;
  if ((is_clamped || study.bounds == StudyBounds::initial) && info.options({}).contains("bounds")) {
    settings["bounds"] = is_clamped ? "clamp" : "initial";
  }
  for (const auto& [name, value] : entrant.options) settings[name] = value;
  return info.options(settings);
}

int effective_population(const Study& study, const Entrant& entrant) {
  return entrant.population > 0 ? entrant.population : study.population;
}

std::vector<Pose> targets(const Study& study, int run) {
  if (const auto* helix = std::get_if<Helix>(&study.path)) return along(*helix);
  if (const auto* circle = std::get_if<Circle>(&study.path)) return along(*circle);
  if (const auto* drawn = std::get_if<RandomTargets>(&study.path)) {
    Random random(Key(study.seed).with("targets").with(static_cast<std::uint64_t>(run)));
    return random_poses(robot(study.robot), drawn->points, random);
  }
  return std::get<std::vector<Pose>>(study.path);
}

std::string why_no_blocks(const Study& study) {
  const bool is_drawn = std::holds_alternative<RandomTargets>(study.path), is_chained = study.start == Start::previous;
  if (is_chained && !is_drawn) {
    return "the solves of a run are chained along a path, so that each solver meets a target from where it left the "
           "arm";
  }
  const std::int64_t blocks =
      (is_drawn ? std::int64_t{study.runs} : 1) * (is_chained ? 1 : std::int64_t{points(study.path)});
  return blocks >= 2 ? "" : "there is only one such target, or one run of them";
}

std::string configuration_key(const Study& study, const Entrant& entrant) {
  // What is new in a study is said only where it is not as before, so that stores keep the solves they have.
  const Robot arm = robot(study.robot);
  std::string text = "numerics 2\nrobot";  // as the first stores have it, whose keys are this hash alone
  text += arm.kinematics->definition() + exact(arm.limits.lower) + exact(arm.limits.upper) + "\ntargets ";
  if (const auto* drawn = std::get_if<RandomTargets>(&study.path)) {
    text += fmt::format("random {}", drawn->points);  // from seed and run
  } else {
    for (const Pose& target : targets(study, 1)) text += exact(target.matrix().reshaped());
  }
  text += fmt::format("\ninitial {}\nsearch {} branch {} population {} seed {} trace {}", exact(study.initial),
                      static_cast<int>(study.search), static_cast<int>(study.wrist_branch),
                      effective_population(study, entrant), study.seed, static_cast<int>(study.trace));
  text += fmt::format("\nstop {} {} {} {}", study.stop.iterations, study.stop.tolerance, study.stop.evaluations,
                      study.stop.seconds);
  if (study.limits == Limits::enforced) text += "\nlimits enforced";
  if (study.start == Start::initial) text += "\nstart initial";
  text += fmt::format("\nsolver {} label {}", entrant.solver, entrant.label);
  for (const auto& [name, value] : effective_options(study, entrant)) text += fmt::format("\n{} = {}", name, value);
  return fmt::format("{:016x}", Key(0).with(text).value());
}

std::string series_key(const Study& study, const Entrant& entrant) {
  const Key source = Key(0).with(shared_source_digest()).with(solver_source_digest(entrant.solver));
  return fmt::format("{}{}{:016x}", configuration_key(study, entrant), before_source, source.value());
}

std::vector<Unreachable> unreachable(const Study& study) {
  if (std::holds_alternative<RandomTargets>(study.path)) return {};
  const Robot arm = robot(study.robot);
  const std::optional<SphericalWrist> wrist =
      study.search == Search::wrist ? std::optional<SphericalWrist>(*arm.chain()) : std::nullopt;
  const Kinematics& searched = wrist ? wrist->arm() : *arm.kinematics;
  const Kinematics::Ball ball = searched.reach();
  std::vector<Unreachable> found;
  int point = 0;
  for (const Pose& target : targets(study, 1)) {
    ++point;
    const Eigen::Vector3d goal = wrist ? wrist->centre(target) : target.translation();
    const double distance = (goal - ball.centre).norm();
    if (distance > ball.radius) found.push_back({point, distance, ball.radius});
  }
  return found;
}

}  // namespace ikbench::experiments
