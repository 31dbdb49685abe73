// The only door to an evaluation: the position error of candidates (Eq. 1), and the count of them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "robots/chain.hpp"

namespace ikbench::solvers {

class Objective {
 public:
  Objective(const robots::Chain& arm, Eigen::Vector3d target) : arm_(arm), target_(std::move(target)) {}
  virtual ~Objective() = default;

  // Position error [m] of every candidate (a column of q) into `errors`; counts one evaluation a candidate.
  void errors(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
    evaluations_ += q.cols();
    evaluate(q, errors);
  }

  // Position error [m] of one candidate; counts one evaluation.
  double error(const robots::ConfigurationRef& q) {
    using AsCandidate = Eigen::Map<const robots::Candidates, 0, Eigen::OuterStride<>>;
    Eigen::Matrix<double, 1, 1> error;
    errors(AsCandidate(q.data(), q.size(), 1, Eigen::OuterStride<>(q.innerStride())), error);
    return error[0];
  }

  // A loop over the candidates in which each is proposed from what those before it have changed, evaluated, and decided
  // on. It looks ahead and evaluates in batches all the same:
  // - propose(first, count) writes these columns of q from the solver's present state;
  // - decide(i) takes candidate i, whose error is errors[i], in or not, and says whether that changed anything that the
  //   proposals after it depend on. If so, those are proposed anew.
  // What is decided on counts as an evaluation, as in the loop as it is written; proposals that are dropped do not.
  template <class Propose, class Decide>
  void one_by_one(robots::Candidates& q, Eigen::VectorXd& errors, Propose&& propose, Decide&& decide) {
    for (Eigen::Index i = 0; i < q.cols();) {
      const Eigen::Index count = std::min(look_ahead_, q.cols() - i), last = i + count;
      propose(i, count);
      evaluate(q.middleCols(i, count), errors.segment(i, count));
      const Eigen::Index first = i;
      bool changed = false;
      while (i < last && !changed) changed = decide(i++);
      evaluations_ += i - first;
      // As far ahead as it pays: half as far after a change, twice as far without. The numbers do not depend on it.
      look_ahead_ = std::min(changed ? std::max<Eigen::Index>(look_ahead_ / 2, 8) : 2 * look_ahead_, furthest_ahead_);
    }
  }

  // The way still to go, target - position [m], and the position's Jacobian (3 x joints) into `jacobian`; counts one
  // evaluation.
  Eigen::Vector3d position_jacobian(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
    ++evaluations_;
    return evaluate_linear(q, jacobian);
  }

  std::int64_t evaluations() const { return evaluations_; }

 protected:
  // With 1 candidate to look ahead at most, one_by_one is that loop as it is written.
  Objective(const robots::Chain& arm, Eigen::Vector3d target, Eigen::Index furthest_ahead)
      : arm_(arm), target_(std::move(target)), look_ahead_(furthest_ahead), furthest_ahead_(furthest_ahead) {}

  virtual void evaluate(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
    arm_.position_errors(q, target_, errors);
  }
  virtual Eigen::Vector3d evaluate_linear(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
    return target_ - arm_.position_jacobian(q, jacobian);
  }

 private:
  const robots::Chain& arm_;
  Eigen::Vector3d target_;
  Eigen::Index look_ahead_ = 64, furthest_ahead_ = 64;  // candidates
  std::int64_t evaluations_ = 0;
};

}  // namespace ikbench::solvers
