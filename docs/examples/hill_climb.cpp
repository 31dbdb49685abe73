// A solver in C++: hill climbing with a normal step that shrinks. It is the example of docs/extending.md; copy it into
// solvers/.
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class HillClimb final : public Solver {
 public:
  // The options. Each is listed once, with its name, member, range and meaning. Its default is the initialiser.
  struct Options {
    double step = 0.5;
    double shrink = 0.97;
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.number("step", step, {0, 10}, "initial step [rad]");
      list.number("shrink", shrink, {0, 1}, "the step is multiplied by this in every iteration");
      list_bounds(list, bounds);
    }
  };

  explicit HillClimb(Options options) : options_(options) {}

  // Allocates all memory, and resets what the previous solve left.
  void start(const Problem& problem, Objective& objective, Random&) override {
    problem_ = problem;
    epsilon_.resize(problem.joints(), problem.population);
    candidate_.resize(problem.joints());
    step_ = options_.step;
    best_ = {problem.start};
    best_.improve(problem.start, objective.error(problem.start));
  }

  // One iteration. It draws all its random numbers first.
  void step(Objective& objective, Random& random) override {
    random.normals(epsilon_);
    for (Eigen::Index i = 0; i < epsilon_.cols(); ++i) {
      candidate_ = best_.q + step_ * epsilon_.col(i);
      keep_inside(options_.bounds, problem_, candidate_);
      best_.improve(candidate_, objective.error(candidate_));
    }
    step_ *= options_.shrink;
  }

  const Best& best() const override { return best_; }

 private:
  Options options_;
  Problem problem_;
  Candidates epsilon_;
  Eigen::VectorXd candidate_;
  double step_ = 0;
  Best best_;
};

}  // namespace

SolverInfo hill_climb() {
  return solver_info<HillClimb>("hill_climb", "hill climbing with a shrinking step", "docs/extending.md");
}

}  // namespace ikbench::solvers
