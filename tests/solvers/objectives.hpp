// Objectives that record, script or spoil the evaluations of a solver, and tasks to evaluate it on.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "base/units.hpp"
#include "numerics/functions.hpp"
#include "numerics/instruction_set.hpp"
#include "robots/robot.hpp"
#include "solvers/bounds.hpp"
#include "solvers/damped_step.hpp"
#include "solvers/kernels.hpp"
#include "solvers/options.hpp"
#include "solvers/solve.hpp"
#include "tests/numerics/guarded.hpp"
#include "tests/numerics/reference.hpp"
#include "tests/solvers/allocations.hpp"
#include "tests/solvers/pseudo_inverse.hpp"
#include "tests/solvers_for.hpp"

using namespace ikbench::base;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

namespace ikbench {

// Records every candidate, one by one. Its errors are the real ones, or those of `script` in order and then infinity.
class RecordingObjective final : public solvers::Objective {
 public:
  RecordingObjective(const robots::Chain& chain, const solvers::Goal& goal) : solvers::Objective(chain, goal, 1) {}
  RecordingObjective(const robots::Chain& chain, std::vector<double> script)
      : solvers::Objective(chain, Eigen::Vector3d(0, 0, 0), 1), scripted_(true), script_(std::move(script)) {}

  std::vector<Eigen::VectorXd> candidates;
  std::vector<double> given;  // the error of each

 private:
  void evaluate(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) override {
    solvers::Objective::evaluate(q, errors);
    for (Eigen::Index i = 0; i < q.cols(); ++i) record(q.col(i), errors[i]);
  }
  solvers::Linearized evaluate_linear(const robots::ConfigurationRef& q,
                                      Eigen::Ref<Eigen::MatrixXd> jacobian) override {
    solvers::Linearized linearized = solvers::Objective::evaluate_linear(q, jacobian);
    record(q, linearized.error);
    return linearized;
  }

  void record(const Eigen::VectorXd& q, double& error) {
    const std::size_t turn = candidates.size();
    if (scripted_) error = turn < script_.size() ? script_[turn] : std::numeric_limits<double>::infinity();
    candidates.push_back(q);
    given.push_back(error);
  }

  bool scripted_ = false;
  std::vector<double> script_;
};

// Looks only at the present candidate, as the pseudo-codes do.
class OneAheadObjective final : public solvers::Objective {
 public:
  OneAheadObjective(const robots::Chain& chain, const solvers::Goal& goal) : solvers::Objective(chain, goal, 1) {}
};

// Gives `value` instead of the error of every `period`-th candidate.
class SpoiltObjective final : public solvers::Objective {
 public:
  SpoiltObjective(const robots::Chain& chain, const solvers::Goal& goal, double value, int period)
      : solvers::Objective(chain, goal), value_(value), period_(period) {}

 private:
  void evaluate(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) override {
    solvers::Objective::evaluate(q, errors);
    for (double& error : errors) {
      if (++turn_ % period_ == 0) error = value_;
    }
  }
  solvers::Linearized evaluate_linear(const robots::ConfigurationRef& q,
                                      Eigen::Ref<Eigen::MatrixXd> jacobian) override {
    const solvers::Linearized linearized = solvers::Objective::evaluate_linear(q, jacobian);
    if (++turn_ % period_ != 0) return linearized;
    jacobian.setConstant(value_);
    return {value_, solvers::Residual::Constant(linearized.to_go.size(), value_)};
  }

  double value_;
  int period_;
  int turn_ = 0;
};

struct Task {
  robots::Chain chain;
  Eigen::Vector3d target;
  solvers::Problem problem;
};

inline solvers::Problem problem_of(const robots::ConfigurationRef& start, const robots::ConfigurationRef& lower,
                                   const robots::ConfigurationRef& upper, int population) {
  return {.start = start, .lower = lower, .upper = upper, .population = population, .iterations = 50};
}

// The iiwa's first four joints placing its wrist's centre, which is within reach.
inline Task iiwa_task(int population = 10) {
  const robots::Robot iiwa = robots::robot("kuka_iiwa14");
  const std::vector<robots::DhLink>& links = iiwa.chain.links();
  return {robots::Chain({links.begin(), links.begin() + 4}, {0, 0, links[4].d}),
          {0.6, 0.2, 0.3},
          problem_of(Eigen::VectorXd::Zero(4), iiwa.limits.lower.head(4), iiwa.limits.upper.head(4), population)};
}

// Any number of joints, with axes alternately upright and level; its target is half of the stretched arm away.
inline Task snake_task(int joints, int population = 10) {
  std::vector<robots::DhLink> links;
  for (int j = 0; j < joints; ++j) links.push_back({.a = 0.1, .alpha = j % 2 == 0 ? 1.5 : -1.5});
  return {robots::Chain(links),
          {0.05 * joints, 0.02 * joints, 0.01},
          problem_of(Eigen::VectorXd::Constant(joints, 0.1), Eigen::VectorXd::Constant(joints, -2),
                     Eigen::VectorXd::Constant(joints, 1.5), population)};
}

// Two joints of a planar arm within +-1 rad, for equations by hand; its start is inside.
inline Task planar_task(int population) {
  return {robots::robot("planar_2").chain,
          {0.5, 0.5, 0},
          problem_of(Eigen::Vector2d(0.3, -0.2), Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1), population)};
}

inline solvers::Solution solve_by(const std::string& name, const solvers::Settings& settings,
                                  const solvers::Problem& problem, solvers::Objective& objective,
                                  const solvers::StopRule& stop) {
  numerics::Random random{numerics::Key(1)};
  return solvers::solve(*solvers::solver(name).make(settings), problem, objective, random, stop);
}

// A task with a pose that the arm reaches within its limits, from their middle.
struct ReachablePose {
  explicit ReachablePose(std::string_view name, std::uint64_t seed, double weight = 0.3)
      : arm(robots::robot(name)), goal(Eigen::Vector3d::Zero()) {
    numerics::Random random{numerics::Key(seed)};
    Eigen::VectorXd q(arm.joints());
    for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(arm.limits.lower[j], arm.limits.upper[j]);
    goal = solvers::Goal(arm.chain.forward(q), weight);
    problem = problem_of((arm.limits.lower + arm.limits.upper) / 2, arm.limits.lower, arm.limits.upper, 50);
  }

  robots::Robot arm;
  solvers::Goal goal;
  solvers::Problem problem;
};

// What is to go from q [m, rad], and its Jacobian.
inline std::pair<robots::Matrix6Xd, Eigen::VectorXd> linearized(const ReachablePose& task, const Eigen::VectorXd& q) {
  std::pair<robots::Matrix6Xd, Eigen::VectorXd> both{robots::Matrix6Xd(6, q.size()), Eigen::VectorXd(6)};
  const robots::Pose reached = task.arm.chain.pose_jacobian(q, both.first);
  const Eigen::AngleAxisd turn(task.goal.target.linear() * reached.linear().transpose());
  both.second << task.goal.target.translation() - reached.translation(), turn.angle() * turn.axis();
  return both;
}

inline bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && (a - b).cwiseAbs().maxCoeff() <= 4e-16 * (1 + b.cwiseAbs().maxCoeff());
}

inline robots::Candidates drawn_uniforms(numerics::Random& random, int rows, int columns) {
  robots::Candidates out(rows, columns);
  random.uniforms(out);
  return out;
}

inline Eigen::VectorXd drawn_vector(numerics::Random& random, int size) {
  Eigen::VectorXd out(size);
  random.uniforms(out);
  return out;
}

}  // namespace ikbench
