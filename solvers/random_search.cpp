// Uniform random search within the joint limits: every other solver has to beat it.
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class RandomSearch final : public Solver {
 public:
  struct Options {
    void list(OptionList&) {}
  };

  explicit RandomSearch(Options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    problem_ = problem;
    x_.resize(problem.joints(), problem.population);
    errors_.resize(problem.population);
    best_ = {problem.start};
    step(objective, random);
  }

  void step(Objective& objective, Random& random) override {
    draw_within_limits(problem_, random, x_);
    objective.errors(x_, errors_);
    for (Eigen::Index i = 0; i < x_.cols(); ++i) best_.improve(x_.col(i), errors_[i]);
  }

  const Best& best() const override { return best_; }

 private:
  Problem problem_;
  Candidates x_;
  Eigen::VectorXd errors_;
  Best best_;
};

}  // namespace

SolverInfo random_search() {
  return solver_info<RandomSearch>("random_search", "uniform random search within the limits", "Brooks 1958");
}

}  // namespace ikbench::solvers
