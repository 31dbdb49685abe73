// For shared objects: the objective of the C interface, under the name that this project's solvers use, so that their
// files compile unchanged (six.cpp).
#pragma once

#include <ikbench_plugin.hpp>

#include "robots/chain.hpp"

namespace ikbench::solvers {

class Objective {
 public:
  explicit Objective(ikbench_plugin::Objective& suite) : suite_(suite) {}

  void errors(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
    suite_.errors(q.data(), q.outerStride(), q.cols(), errors.data());
  }
  double error(const robots::ConfigurationRef& q) {
    double error = 0;
    suite_.errors(q.data(), q.innerStride(), 1, &error);
    return error;
  }
  template <class Propose, class Decide>
  void one_by_one(robots::Candidates& q, Eigen::VectorXd& errors, Propose&& propose, Decide&& decide) {
    suite_.one_by_one(q.data(), q.cols(), errors.data(), propose, decide);
  }

 private:
  ikbench_plugin::Objective& suite_;
};

}  // namespace ikbench::solvers
