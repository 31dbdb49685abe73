// Compares an IK-BA solve of seven joints (population 50, 200 iterations) with a variant that updates once per
// iteration and with a textbook program.
#include "experiments/microbenchmarks/harness.hpp"
#include "experiments/microbenchmarks/textbook_ik_bat.hpp"
#include "numerics/functions.hpp"
#include "solvers/bounds.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

constexpr int iterations = 200;

// IK-BA with its defaults, except that a new best counts from the next iteration on: one batch per iteration.
class SynchronousIkBat final : public Solver {
 public:
  void start(const Problem& problem, Objective& objective, Random& random) override {
    theta_s_ = problem.start;
    x_.resize(problem.joints(), problem.population);
    v_.setZero(problem.joints(), problem.population);
    epsilon_.resize(problem.joints(), problem.population);
    candidates_.resize(problem.joints(), problem.population);
    for (Eigen::VectorXd* each : {&errors_, &frequency_, &chance_}) each->resize(problem.population);
    loudness_ = 1;
    iteration_ = 0;
    best_.q = problem.start;
    best_.error = std::numeric_limits<double>::infinity();
    draw_within_limits(problem, random, x_);
    x_.col(0) = problem.start;
    objective.errors(x_, errors_);
    Eigen::Index i;
    const double error = errors_.minCoeff(&i);
    best_.improve(x_.col(i), error);
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(frequency_);
    random.normals(epsilon_);
    random.uniforms(chance_);                               // for the acceptance, which by default needs none
    frequency_ *= 2;                                        // Eq. 5
    loudness_ *= 0.97;                                      // Eq. 9
    const double r = 1 - exponential(-0.1 * iteration_++);  // Eq. 10
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      double *const x = &x_(j, 0), *const v = &v_(j, 0);
      kernels_.fly({.pole = 0.5 * (best_.q[j] + theta_s_[j]),  // Eqs. 13 and 7
                    .frequency = frequency_.data(),
                    .x = x,
                    .v = v,
                    .x_next = x,
                    .v_next = v,
                    .count = x_.cols()});
      kernels_.scatter(r * best_.q[j] + (1 - r) * theta_s_[j], 0.1 * loudness_, &epsilon_(j, 0), &candidates_(j, 0),
                       x_.cols());  // Eq. 14
    }
    objective.errors(candidates_, errors_);
    Eigen::Index i;
    const double error = errors_.minCoeff(&i);
    if (best_.improve(candidates_.col(i), error)) x_.col(i) = candidates_.col(i);
  }

  const Best& best() const override { return best_; }

 private:
  Eigen::VectorXd theta_s_, errors_, frequency_, chance_;
  Candidates x_, v_, epsilon_, candidates_;
  const solvers::Kernels& kernels_ = solvers::kernels();
  double loudness_ = 1;
  int iteration_ = 0;
  Best best_;
};

void measure(benchmark::State& state, Solver& solver) {
  const Reach reach = flange_reach();
  Random random{Key(1)};
  double sum = 0;
  for (auto _ : state) {
    Objective objective(reach.chain, reach.target);
    sum += solve(solver, reach.problem, objective, random, {.iterations = iterations}).best.error;
  }
  state.counters["error_cm"] = benchmark::Counter(100 * sum, benchmark::Counter::kAvgIterations);
}

void ours(benchmark::State& state) { measure(state, *solver("ik_bat").make({})); }

void synchronous(benchmark::State& state) {
  SynchronousIkBat solver;
  measure(state, solver);
}

void textbook_solve(benchmark::State& state) {
  const Reach reach = flange_reach();
  std::vector<textbook::Link> links;
  for (const DhLink& link : reach.chain.links()) links.push_back({link.a, link.alpha, link.d});
  const auto to_vector = [](const Eigen::VectorXd& values) { return textbook::Vector(values.begin(), values.end()); };
  const textbook::Vector target = to_vector(reach.target), start = to_vector(reach.problem.start),
                         lower = to_vector(reach.problem.lower), upper = to_vector(reach.problem.upper);
  const Candidates q = drawn_candidates(reach.problem, 50);
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    const textbook::Vector position = textbook::forward_kinematics(links, to_vector(q.col(i)));
    if (!is_same_position(state, reach.chain, q.col(i), Eigen::Vector3d(position.data()))) return;
  }
  std::mt19937_64 generator(1);
  double sum = 0;
  for (auto _ : state) {
    sum += textbook::ik_bat(links, target, start, lower, upper, reach.problem.population, iterations, generator).error;
  }
  state.counters["error_cm"] = benchmark::Counter(100 * sum, benchmark::Counter::kAvgIterations);
}

BENCHMARK(ours)->Name("ik_bat/ours")->Unit(benchmark::kMicrosecond);
BENCHMARK(synchronous)->Name("ik_bat/synchronous")->Unit(benchmark::kMicrosecond);
BENCHMARK(textbook_solve)->Name("ik_bat/textbook")->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) { return ikbench::microbenchmarks::run(argc, argv); }
