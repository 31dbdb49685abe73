// What goals.csv asks for, as Google Benchmark measures it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/environment.hpp"
#include "experiments/microbenchmarks/kernels.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"
#include "numerics/instruction_set.hpp"
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"
#ifdef IKBENCH_HAS_KDL
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#endif

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;

IKBENCH_DEFINE_KERNELS

namespace {

// The problem that all measure: bring the flange of the iiwa, by all seven joints, to the first point of the paper's
// helix.
struct Reach {
  Robot arm = robot("kuka_iiwa14");
  Eigen::Vector3d target = experiments::targets(experiments::Study{}, 1).front().translation();
  Problem problem{
      .start = Eigen::VectorXd::Zero(7), .lower = arm.limits.lower, .upper = arm.limits.upper, .population = 50};

  Candidates candidates() const {
    Candidates drawn(7, problem.population);
    Random random{Key(1)};
    draw_within_limits(problem, random, drawn);
    return drawn;
  }

  // Eqs. 1, 18 and 26, letter by letter.
  double textbook_error(const Eigen::Ref<const Eigen::VectorXd>& q) const {
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const DhLink& link = arm.chain.links()[static_cast<std::size_t>(j)];
      const double c = std::cos(q[j] + link.offset), s = std::sin(q[j] + link.offset);
      const double ca = std::cos(link.alpha), sa = std::sin(link.alpha);
      Eigen::Matrix4d T_link;
      T_link << c, -s * ca, s * sa, link.a * c,  //
          s, c * ca, -c * sa, link.a * s,        //
          0, sa, ca, link.d,                     //
          0, 0, 0, 1;
      T = T * T_link;
    }
    return (T.block<3, 1>(0, 3) - target).norm();
  }
};

// ---- position errors of 50 candidates: by our chain, by its limit (a kernel for this arm alone), and one after the
// other by products of 4x4 matrices (Eigen) and by KDL

// Times `evaluate(errors)`, after a look that its errors are ours.
template <class Evaluate>
void measure(benchmark::State& state, const Reach& reach, const Evaluate& evaluate) {
  Eigen::VectorXd errors(reach.problem.population), expected = errors;
  evaluate(errors);
  reach.arm.chain.position_errors(reach.candidates(), reach.target, expected);
  if (!((errors - expected).cwiseAbs().maxCoeff() <= 1e-12)) state.SkipWithError("the errors differ from ours");
  for (auto _ : state) {
    evaluate(errors);
    benchmark::DoNotOptimize(errors.data());
    benchmark::ClobberMemory();
  }
}

void ours(benchmark::State& state) {
  const Reach reach;
  const Candidates q = reach.candidates();
  measure(state, reach, [&](Eigen::VectorXd& errors) { reach.arm.chain.position_errors(q, reach.target, errors); });
}

void limit(benchmark::State& state) {
  const Reach reach;
  const Candidates q = reach.candidates();
  const Kernels iiwa = microbenchmarks::kernels(instruction_set());
  measure(state, reach, [&](Eigen::VectorXd& errors) {
    iiwa.iiwa_errors(reach.target.data(), q.data(), q.outerStride(), q.cols(), errors.data());
  });
}

void eigen(benchmark::State& state) {
  const Reach reach;
  const Eigen::MatrixXd q = reach.candidates();
  measure(state, reach, [&](Eigen::VectorXd& errors) {
    for (Eigen::Index i = 0; i < q.cols(); ++i) errors[i] = reach.textbook_error(q.col(i));
  });
}

BENCHMARK(ours)->Name("forward_kinematics/ours");
BENCHMARK(limit)->Name("forward_kinematics/limit");
BENCHMARK(eigen)->Name("forward_kinematics/Eigen");

#ifdef IKBENCH_HAS_KDL
// As KDL is meant to be called. It gives the whole pose.
void kdl(benchmark::State& state) {
  const Reach reach;
  KDL::Chain chain;
  for (const DhLink& link : reach.arm.chain.links())
    chain.addSegment(
        KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame::DH(link.a, link.alpha, link.d, link.offset)));
  const KDL::Vector target(reach.target.x(), reach.target.y(), reach.target.z());
  const Candidates candidates = reach.candidates();
  std::vector<KDL::JntArray> q(static_cast<std::size_t>(candidates.cols()), KDL::JntArray(7));
  for (std::size_t i = 0; i < q.size(); ++i) q[i].data = candidates.col(static_cast<Eigen::Index>(i));
  KDL::ChainFkSolverPos_recursive solver(chain);
  KDL::Frame pose;
  measure(state, reach, [&](Eigen::VectorXd& errors) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      solver.JntToCart(q[i], pose);
      errors[static_cast<Eigen::Index>(i)] = (pose.p - target).Norm();
    }
  });
}
BENCHMARK(kdl)->Name("forward_kinematics/KDL");
#endif

// ---- a solve of the paper (population 50, 200 iterations) by our six solvers, and what each needs at least

constexpr int iterations = 200;

// The means of all solves.
void count(benchmark::State& state, double error, double evaluations) {
  state.counters["error_cm"] = benchmark::Counter(100 * error, benchmark::Counter::kAvgIterations);
  state.counters["evaluations"] = benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}

void registered(benchmark::State& state, const char* name) {
  const Reach reach;
  const std::unique_ptr<Solver> solver = solvers::solver(name).make({});
  Random random{Key(1)};
  double error = 0, evaluations = 0;
  for (auto _ : state) {
    Objective objective(reach.arm.chain, reach.target);
    const Solution solution = solve(*solver, reach.problem, objective, random, {.iterations = iterations});
    error += solution.best.error;
    evaluations += static_cast<double>(solution.evaluations);
  }
  count(state, error, evaluations);
}

// How often an iteration evaluates all candidates, and draws a number for each of them, or for each of their joints.
struct Needs {
  int evaluations = 1, uniforms = 0, uniforms_of_joints = 0, normals_of_joints = 0;
};

// What no implementation can leave out: the solver's random numbers, and its evaluations in full batches.
void floor(benchmark::State& state, Needs needs) {
  const Reach reach;
  const Candidates q = reach.candidates();
  Candidates of_joints = q;
  Eigen::VectorXd errors(q.cols()), of_candidates = errors;
  Random random{Key(1)};
  double evaluations = 0;
  for (auto _ : state) {
    Objective objective(reach.arm.chain, reach.target);
    for (int t = 0; t < iterations; ++t) {
      for (int k = 0; k < needs.uniforms; ++k) random.uniforms(of_candidates);
      for (int k = 0; k < needs.uniforms_of_joints; ++k) random.uniforms(of_joints);
      for (int k = 0; k < needs.normals_of_joints; ++k) random.normals(of_joints);
      for (int k = 0; k < needs.evaluations; ++k) objective.errors(q, errors);
    }
    benchmark::DoNotOptimize(errors.data());
    evaluations += static_cast<double>(objective.evaluations());
  }
  count(state, errors.minCoeff(), evaluations);
}

// All six on an arm of many joints, with many candidates. Counts an evaluation as often as there are joints.
void growth(benchmark::State& state) {
  const Eigen::Index joints = state.range(0);
  std::vector<DhLink> links;
  for (Eigen::Index j = 0; j < joints; ++j)
    links.push_back({.alpha = (j % 2 == 0 ? -0.5 : 0.5) * std::numbers::pi, .d = 0.3});
  const Chain snake(links, Eigen::Vector3d(0.1, 0, 0.1));
  const Problem problem{.start = Eigen::VectorXd::Zero(joints),
                        .lower = Eigen::VectorXd::Constant(joints, -2),
                        .upper = Eigen::VectorXd::Constant(joints, 2),
                        .population = static_cast<int>(state.range(1))};
  Random random{Key(1)};
  double evaluations = 0;
  for (auto _ : state) {
    for (const char* name : {"ik_bat", "bat", "differential_evolution", "particle_swarm", "k_artificial_bee_colony",
                             "multi_objective_swarm"}) {
      Objective objective(snake, Eigen::Vector3d(0.3, 0.2, 0.5));
      solve(*solvers::solver(name).make({}), problem, objective, random, {.iterations = iterations});
      evaluations += static_cast<double>(objective.evaluations() * joints);
    }
  }
  count(state, 0, evaluations);
}

#define MEASURE(function, name, argument, by) \
  BENCHMARK_CAPTURE(function, name, argument)->Name("solvers/" #name "/" by)->Unit(benchmark::kMicrosecond)
#define SOLVER(name, ...)                   \
  MEASURE(registered, name, #name, "ours"); \
  MEASURE(floor, name, (Needs{__VA_ARGS__}), "floor")
SOLVER(ik_bat, .uniforms = 2, .normals_of_joints = 1);
SOLVER(bat, .uniforms = 3, .normals_of_joints = 1);
SOLVER(differential_evolution, .uniforms = 4, .uniforms_of_joints = 1);
SOLVER(particle_swarm, .uniforms_of_joints = 2);
SOLVER(k_artificial_bee_colony, .evaluations = 2, .uniforms = 5);
SOLVER(multi_objective_swarm, .uniforms = 2, .uniforms_of_joints = 2);
BENCHMARK(growth)->Args({4, 50})->Args({32, 50})->Args({7, 50})->Args({7, 5000})->Unit(benchmark::kMillisecond);

// ---- the whole helix study, slim2023: six solvers, 2400 solves, with timing and verifier, without store and report;
// by one thread and by two

void whole_study(benchmark::State& state) {
  const experiments::Study study = experiments::load_study("slim2023");
  for (auto _ : state) experiments::solve_study(study, static_cast<int>(state.range(0)), [](results::SolveRecord) {});
}

BENCHMARK(whole_study)
    ->Name("study/threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  for (const auto& [key, value] : ikbench::experiments::environment())
    if (key != "date") benchmark::AddCustomContext(key, value);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
