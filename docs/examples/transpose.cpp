// A solver for ikbench in a shared object: the best of some random candidates, and from there down the slope (Jacobian
// transpose). shared_object = "./transpose.so"; g++ -std=c++17 -O2 -fPIC -shared -o transpose.so transpose.cpp
#include <algorithm>
#include <ikbench_plugin.hpp>
#include <vector>

using ikbench_plugin::Best, ikbench_plugin::Objective;

class Transpose {
 public:
  explicit Transpose(const ikbench_robot& robot) : shrink_(robot.options[0]), joints_(robot.joints) {
    if (std::count(robot.types, robot.types + joints_, 2) > 0) throw ikbench_plugin::Declined("no coupled joints");
  }
  void start(const ikbench_problem& problem, Objective& objective, Best& best) {
    lower_.assign(problem.lower, problem.lower + joints_);
    upper_.assign(problem.upper, problem.upper + joints_);
    some_ = problem.population;
    draw(objective, best);
  }
  void step(Objective& objective, Best& best) {
    if (step_ < 1e-3) return draw(objective, best);
    double residual[6], squared = 1e-12, length = 0;
    std::vector<double> slope(6 * joints_), way(joints_), next(joints_), moved(6);
    const int rows = objective.linearize(q_.data(), residual, slope.data());
    for (int j = 0; j < joints_; ++j) {
      for (int i = 0; i < rows; ++i) way[j] += slope[j * rows + i] * residual[i];
      for (int i = 0; i < rows; ++i) moved[i] += slope[j * rows + i] * way[j];
      length += way[j] * way[j];
    }
    for (const double m : moved) squared += m * m;  // length / squared: the step to the end of a linear slope
    for (int j = 0; j < joints_; ++j)
      next[j] = std::clamp(q_[j] + step_ * length / squared * way[j], lower_[j], upper_[j]);
    const double error = objective.error(next.data());
    step_ = error < error_ ? 1 : step_ * shrink_;
    if (error < error_) take(next, error, best);
  }

 private:
  void draw(Objective& objective, Best& best) {  // candidate i has its joint j at q[j * some_ + i]
    std::vector<double> q(joints_ * some_), errors(some_), chosen(joints_);
    objective.uniforms(q.data(), q.size());
    for (int k = 0; k < joints_ * some_; ++k) q[k] = lower_[k / some_] + (upper_[k / some_] - lower_[k / some_]) * q[k];
    objective.errors(q.data(), some_, some_, errors.data());
    const long least = std::min_element(errors.begin(), errors.end()) - errors.begin();
    for (int j = 0; j < joints_; ++j) chosen[j] = q[j * some_ + least];
    step_ = 1, take(chosen, errors[least], best);
  }
  void take(const std::vector<double>& q, double error, Best& best) {
    q_ = q, error_ = error;
    if (error < best.error) best.error = error, std::copy(q.begin(), q.end(), best.q);
  }

  double shrink_, error_ = 0, step_ = 1;
  int joints_, some_ = 0;
  std::vector<double> lower_, upper_, q_;
};

IKBENCH_SOLVERS(ikbench_plugin::solver<Transpose>(
    "transpose", "1.0", R"([{"name": "shrink", "default": 0.5, "low": 0.1, "high": 0.9, "meaning": "of a step"}])"))
