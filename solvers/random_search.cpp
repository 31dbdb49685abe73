// Uniform random search within the joint limits: every other solver has to beat it.
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

namespace {

class RandomSearch final : public Searcher {
 public:
  struct Options {
    void list(OptionList&) {}
  };

  explicit RandomSearch(Options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    take(problem);
    x_.resize(problem.joints(), problem.population);
    errors_.resize(problem.population);
    step(objective, random);
  }

  void step(Objective& objective, Random& random) override {
    draw_within_limits(problem_, random, x_);
    evaluate_all(objective, x_, errors_);
  }

 private:
  Candidates x_;
  Eigen::VectorXd errors_;
};

}  // namespace

SolverInfo random_search() {
  return solver_info<RandomSearch>("random_search", "uniform random search within the limits", "Brooks 1958", 1);
}

}  // namespace ikbench::solvers
