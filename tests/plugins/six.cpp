// The solvers of the paper as a shared object: their unchanged files behind the C interface. A test compares their
// answers with the built-in ones, a benchmark their times.
#include <algorithm>
#include <memory>

#include "numerics/instruction_set.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

IKBENCH_DEFINE_KERNELS

SolverInfo ik_bat();
SolverInfo bat();
SolverInfo particle_swarm();
SolverInfo differential_evolution();
SolverInfo k_artificial_bee_colony();
SolverInfo multi_objective_swarm();

namespace {

template <SolverInfo (*info)()>
class Hosted {
 public:
  explicit Hosted(const ikbench_robot& robot) : joints_(robot.joints), solver_(info().make({})) {}

  void start(const ikbench_problem& told, ikbench_plugin::Objective& suite, ikbench_plugin::Best& best) {
    using Numbers = Eigen::Map<const Eigen::VectorXd>;
    const Problem problem{.start = Numbers(told.start, joints_),
                          .lower = Numbers(told.lower, joints_),
                          .upper = Numbers(told.upper, joints_),
                          .population = told.population,
                          .iterations = told.iterations};
    Objective objective(suite);
    numerics::Random random(suite);
    solver_->start(problem, objective, random);
    tell(best);
  }
  void step(ikbench_plugin::Objective& suite, ikbench_plugin::Best& best) {
    Objective objective(suite);
    numerics::Random random(suite);
    solver_->step(objective, random);
    tell(best);
  }

 private:
  void tell(ikbench_plugin::Best& best) const {
    const Best& found = solver_->best();
    std::copy_n(found.q.data(), joints_, best.q);
    best.error = found.error;
    best.is_finished = solver_->finished();
  }

  int joints_;
  std::unique_ptr<Solver> solver_;
};

template <SolverInfo (*info)()>
constexpr ikbench_solver hosted(const char* name) {
  return ikbench_plugin::solver<Hosted<info>>(name, "1");
}

}  // namespace

}  // namespace ikbench::solvers

using namespace ikbench::solvers;

IKBENCH_SOLVERS(hosted<ik_bat>("ik_bat"), hosted<bat>("bat"), hosted<particle_swarm>("particle_swarm"),
                hosted<differential_evolution>("differential_evolution"),
                hosted<k_artificial_bee_colony>("k_artificial_bee_colony"),
                hosted<multi_objective_swarm>("multi_objective_swarm"))
