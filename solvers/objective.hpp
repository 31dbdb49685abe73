// The only door to an evaluation: the position error of candidates (Eq. 1), and an honest count of them.
#pragma once

#include <cstdint>

#include "robots/chain.hpp"

namespace ikbench {

class Objective {
 public:
  Objective(const Chain& chain, Eigen::Vector3d target) : chain_(chain), target_(std::move(target)) {}
  virtual ~Objective() = default;

  // Position error [m] of every candidate (a column of q) into `errors`; counts one evaluation a candidate.
  void errors(const CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
    evaluations_ += q.cols();
    evaluate(q, errors);
  }

  // Position error [m] of one candidate; counts one evaluation.
  double error(const ConfigurationRef& q) {
    using AsCandidate = Eigen::Map<const Candidates, 0, Eigen::OuterStride<>>;
    Eigen::Matrix<double, 1, 1> error;
    errors(AsCandidate(q.data(), q.size(), 1, Eigen::OuterStride<>(q.innerStride())), error);
    return error[0];
  }

  // The way still to go, target - position [m], and the position's Jacobian (3 x joints) into `jacobian`; counts one
  // evaluation.
  Eigen::Vector3d linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
    ++evaluations_;
    return evaluate_linear(q, jacobian);
  }

  std::int64_t evaluations() const { return evaluations_; }

 protected:
  virtual void evaluate(const CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
    chain_.position_errors(q, target_, errors);
  }
  virtual Eigen::Vector3d evaluate_linear(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) {
    chain_.position_jacobian(q, jacobian);
    return target_ - chain_.position(q);
  }

 private:
  const Chain& chain_;
  Eigen::Vector3d target_;
  std::int64_t evaluations_ = 0;
};

}  // namespace ikbench
