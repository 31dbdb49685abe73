// flags = -lorocos-kdl
// KDL as kdl.py asks it: LMA from random starts until an answer, turned by whole turns, is inside the limits, which
// it does not know; or Newton, clipped at the limits.
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

#include "kdl_chain.hpp"

struct Library {  // of one tolerance, the study's
  explicit Library(const ikbench::Robot& robot) : chain(chain_of(robot)), forward(chain), velocity(chain) {
    turns = robot.turns;
    is_newton = robot.message["options"]["method"].text == "newton";
    steps = static_cast<int>(robot.option("steps"));
  }
  Library(Library&& other) = delete;

  KDL::ChainIkSolverPos& solver(const ikbench::Problem& problem) {
    if (solver_) return *solver_;
    const double near = problem.near, near_angle = problem.near_angle;
    if (is_newton) {
      const double within = std::min(near, near_angle) / std::sqrt(3.0);
      solver_ = std::make_unique<KDL::ChainIkSolverPos_NR_JL>(chain, array(problem.lower), array(problem.upper),
                                                              forward, velocity, steps, within > 0 ? within : 1e-5);
    } else {  // a radian weighs 0.01 m in it
      const double within = std::min(near, 0.01 * near_angle);
      solver_ = std::make_unique<KDL::ChainIkSolverPos_LMA>(chain, within > 0 ? within : 1e-5, steps);
    }
    return *solver_;
  }

  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainIkSolverVel_pinv velocity;
  std::vector<bool> turns;
  bool is_newton = false;
  int steps = 0;

 private:
  std::unique_ptr<KDL::ChainIkSolverPos> solver_;
};

Values solve(std::unique_ptr<Library>& library, ikbench::Problem& problem) {
  const KDL::Frame target = frame_of(target_of(problem));
  KDL::JntArray answer = array(problem.start);
  return from_starts(problem, [&](const Values& start) -> Values {
    if (library->solver(problem).CartToJnt(array(start), target, answer) < 0) return {};
    const Values q = ikbench::inside(values(answer), library->turns, problem.lower, problem.upper);
    for (std::size_t j = 0; j < q.size(); ++j)
      if (q[j] < problem.lower[j] || q[j] > problem.upper[j]) return {};
    return q;
  });
}

int main() {
  ikbench::run(
      "kdl",
      R"([{"name": "method", "default": "lma", "choices": ["lma", "newton"], "meaning": "which of its solvers"}, )"
      R"({"name": "steps", "type": "integer", "default": 60, "low": 1, "high": 100000, "meaning": "steps before the next start"}])",
      [](const ikbench::Robot& robot) { return std::make_unique<Library>(robot); }, solve, R"(["pose"])");
}
