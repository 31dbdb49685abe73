// The objective of a solve: the error of candidates, which is their distance from the goal. Solvers evaluate only
// through this class, which counts the evaluations.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

#include "robots/chain.hpp"

namespace ikbench::solvers {

// The part of the tool's pose that a goal prescribes.
// position: the position.
// axis: the position and the direction of the z axis.
// pose: position and orientation.
enum class GoalKind { position, axis, pose };

// The goal of a solve.
struct Goal {
  Goal(const Eigen::Vector3d& position) { target.translation() = position; }
  Goal(const robots::Pose& pose, double weight, GoalKind prescribed = GoalKind::pose)
      : kind(prescribed), target(pose), rotation_weight(weight) {}

  GoalKind kind = GoalKind::position;
  robots::Pose target = robots::Pose::Identity();
  double rotation_weight = 0;  // [m] weight of a radian; 0: position only

  bool has_direction() const { return kind != GoalKind::position; }
};

// The distance of the tool from the goal.
struct Deviation {
  double position = 0;  // [m]
  double angle = 0;     // [rad], 0 to pi; of the z axis if the goal is an axis, otherwise of the whole tool
};

// The residual of a goal: 3 or 6 numbers [m], not on the heap.
using Residual = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;

// A candidate after a linearization.
struct Linearized {
  double error;    // [m]
  Residual to_go;  // [m]
};

// The objective. A derived class may evaluate in another way, such as by a program.
class Objective {
 public:
  // `max_ahead`: candidates that one_by_one may evaluate ahead; 1 makes it a plain loop.
  Objective(const robots::Chain& arm, Goal goal, Eigen::Index max_ahead = 64)
      : arm_(arm), goal_(std::move(goal)), look_ahead_(max_ahead), max_ahead_(max_ahead) {}
  virtual ~Objective() = default;

  const robots::Chain& arm() const { return arm_; }
  const Goal& goal() const { return goal_; }

  // Writes the error [m] of every candidate (a column of q) into `errors`: the position error (Eq. 1), or the root mean
  // square of the distances of three points of the tool (Chain::pose_errors). The error is 0 only at the goal, and
  // smooth elsewhere. Counts one evaluation per candidate.
  void errors(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
    evaluations_ += q.cols();
    evaluate(q, errors);
  }

  // Returns the error [m] of one candidate, and counts one evaluation.
  double error(const robots::ConfigurationRef& q) {
    using AsCandidate = Eigen::Map<const robots::Candidates, 0, Eigen::OuterStride<>>;
    Eigen::Matrix<double, 1, 1> error;
    errors(AsCandidate(q.data(), q.size(), 1, Eigen::OuterStride<>(q.innerStride())), error);
    return error[0];
  }

  // Loops over the candidates: each is proposed from the state that earlier ones left, evaluated, and decided on. The
  // loop looks ahead and evaluates in batches, with the numbers of a plain loop:
  // - propose(first, count) writes these columns of q from the solver's present state.
  // - decide(i) accepts or refuses candidate i, whose error is errors[i]. It returns true if later proposals depend on
  //   something that has changed; they are then proposed again.
  // - renew(i) is for changes that concern few candidates. Before the decision it proposes candidate i again if it has
  //   to, and returns whether it did.
  // Only decided candidates count as evaluations, as in the plain loop. `q` are Candidates and `errors` a vector.
  template <class Q, class Errors, class Propose, class Decide, class Renew>
  void one_by_one(Q& q, Errors& errors, Propose&& propose, Decide&& decide, Renew&& renew) {
    for (Eigen::Index i = 0; i < q.cols();) {
      const Eigen::Index count = std::min(look_ahead_, q.cols() - i);
      propose(i, count);
      evaluate(q.middleCols(i, count), errors.segment(i, count));
      Eigen::Index decided = 0;
      bool changed = false;
      while (decided < count && !changed) {
        const Eigen::Index next = i + decided++;
        if (renew(next)) evaluate(q.middleCols(next, 1), errors.segment(next, 1));
        changed = decide(next);
      }
      i += decided;
      evaluations_ += decided;
      // Looks half as far ahead after a change, twice as far without. The numbers do not depend on it.
      look_ahead_ = std::min(changed ? std::max<Eigen::Index>(look_ahead_ / 2, 8) : 2 * look_ahead_, max_ahead_);
    }
  }

  template <class Q, class Errors, class Propose, class Decide>
  void one_by_one(Q& q, Errors& errors, Propose&& propose, Decide&& decide) {
    one_by_one(q, errors, propose, decide, [](Eigen::Index) { return false; });
  }

  // Returns the rows of a residual: 3 for a position, otherwise 6.
  int rows() const { return goal_.has_direction() ? 6 : 3; }
  // Returns error and residual of one candidate, and counts one evaluation. The residual is target - position [m] and,
  // for an axis or a pose, rotation_weight times the remaining rotation vector [m], in the axes of the base. For an
  // axis that is the shortest turn of the axis, and the Jacobian has no turn about the axis. Writes the geometric
  // Jacobian in the same units into `jacobian`, rows() x joints, so that J dq = residual is Newton's step. The norm of
  // a residual of 6 rows differs from the error.
  Linearized linearize(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::MatrixXd> jacobian) {
    ++evaluations_;
    return evaluate_linear(q, jacobian);
  }

  // Returns the deviation of a configuration from the goal's pose, also if only a position is searched. For answers: it
  // counts no evaluation.
  Deviation deviation(const robots::ConfigurationRef& q) const;

  std::int64_t evaluations() const { return evaluations_; }

  // Keeps a number of the solver's own, which becomes an extra of the solve in the store.
  void note(const std::string& name, double value) { notes_[name] = value; }
  const std::map<std::string, double>& notes() const { return notes_; }

 protected:
  virtual void evaluate(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors);
  virtual Linearized evaluate_linear(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::MatrixXd> jacobian);

 private:
  Eigen::Vector3d turn_from(const Eigen::Matrix3d& reached) const;  // the rotation vector that is left

  const robots::Chain& arm_;
  Goal goal_;
  Eigen::Index look_ahead_, max_ahead_;  // candidates
  std::int64_t evaluations_ = 0;
  std::map<std::string, double> notes_;
};

}  // namespace ikbench::solvers
