#include "experiments/study.hpp"

#include <fmt/format.h>

#include <optional>

#include "robots/spherical_wrist.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

// To be raised whenever the same study gives other numbers than before, so that a store never mixes the two.
constexpr int numerics_version = 2;

// Slim et al. 2023, Sec. 5.2, in the readings of docs/paper-notes.md section 2.
Study slim2023() {
  Study study{.name = "slim2023",
              .title = "Slim et al. 2023: six solvers on a helix with the KUKA LBR iiwa 14",
              .published = "slim2023"};
  study.initial = Eigen::VectorXd::Zero(7);
  study.solvers = {{"IK-BA", "ik_bat", {}},
                   {"BA", "bat", {}},
                   {"DE", "differential_evolution", {{"replacement", "at_once"}}},  // docs/paper-notes.md 2.9
                   {"PSO", "particle_swarm", {}},
                   {"K-ABC", "k_artificial_bee_colony", {}},
                   {"MO-PSO", "multi_objective_swarm", {}}};
  return study;
}

// What the six are measured against: no skill at all, and what a roboticist would use.
Study slim2023_context() {
  Study study = slim2023();
  study.name = "slim2023-context";
  study.title = "The helix of Slim et al. 2023 with random search and damped least squares";
  study.published = "";
  study.stop.tolerance = 1e-8;  // [m]; else damped least squares would be timed long after it has converged
  study.solvers = {{"Random", "random_search", {}}, {"DLS", "damped_least_squares", {}}};
  return study;
}

template <class Values>
std::string exact(const Values& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{} ", value);
  return text;
}

}  // namespace

std::vector<Study> studies() { return {slim2023(), slim2023_context()}; }

Settings effective_options(const Study& study, const Entrant& entrant) {
  const SolverInfo info = solver(entrant.solver);
  Settings settings;
  if (study.bounds != StudyBounds::per_solver && info.options({}).contains("bounds")) {
    settings["bounds"] = study.bounds == StudyBounds::initial ? "initial" : "clamp";
  }
  for (const auto& [name, value] : entrant.options) settings[name] = value;
  return info.options(settings);
}

std::string series_key(const Study& study, const Entrant& entrant) {
  const Robot arm = robot(study.robot);
  std::string text = fmt::format("numerics {}\nrobot", numerics_version);
  text += arm.kinematics->definition() + exact(arm.limits.lower) + exact(arm.limits.upper) + "\ntargets ";
  for (const Pose& target : targets(study.path)) text += exact(target.matrix().reshaped());
  text += fmt::format("\ninitial {}\nsearch {} branch {} population {} seed {} trace {}", exact(study.initial),
                      static_cast<int>(study.search), static_cast<int>(study.wrist_branch), study.population,
                      study.seed, static_cast<int>(study.trace));
  text += fmt::format("\nstop {} {} {} {}", study.stop.iterations, study.stop.tolerance, study.stop.evaluations,
                      study.stop.seconds);
  text += fmt::format("\nsolver {} label {}", entrant.solver, entrant.label);
  for (const auto& [name, value] : effective_options(study, entrant)) text += fmt::format("\n{} = {}", name, value);
  return fmt::format("{:016x}", Key(0).with(text).value());
}

std::vector<Unreachable> unreachable(const Study& study) {
  const Robot arm = robot(study.robot);
  const std::optional<SphericalWrist> wrist =
      study.search == Search::wrist ? std::optional<SphericalWrist>(*arm.chain()) : std::nullopt;
  const Kinematics& searched = wrist ? wrist->arm() : *arm.kinematics;
  const Kinematics::Ball ball = searched.reach();
  std::vector<Unreachable> found;
  int point = 0;
  for (const Pose& target : targets(study.path)) {
    ++point;
    const Eigen::Vector3d goal = wrist ? wrist->centre(target) : target.translation();
    const double distance = (goal - ball.centre).norm();
    if (distance > ball.radius) found.push_back({point, distance, ball.radius});
  }
  return found;
}

}  // namespace ikbench
