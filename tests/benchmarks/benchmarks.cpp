// What goals.csv asks for, as Google Benchmark measures it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/environment.hpp"
#include "experiments/runner.hpp"
#include "experiments/study/reader.hpp"
#include "numerics/instruction_set.hpp"
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"
#include "tests/benchmarks/kernels.hpp"
#ifdef IKBENCH_HAS_KDL
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#endif

namespace ikbench::benchmarks {

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
void measure(benchmark::CacheState& state, const Reach& reach, const Evaluate& evaluate) {
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

void ours(benchmark::CacheState& state) {
  const Reach reach;
  const Candidates q = reach.candidates();
  measure(state, reach, [&](Eigen::VectorXd& errors) { reach.arm.chain.position_errors(q, reach.target, errors); });
}

void limit(benchmark::CacheState& state) {
  const Reach reach;
  const Candidates q = reach.candidates();
  const Kernels iiwa = benchmarks::kernels(instruction_set());
  measure(state, reach, [&](Eigen::VectorXd& errors) {
    iiwa.iiwa_errors(reach.target.data(), q.data(), q.outerStride(), q.cols(), errors.data());
  });
}

void eigen(benchmark::CacheState& state) {
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
void kdl(benchmark::CacheState& state) {
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
void count(benchmark::CacheState& state, double error, double evaluations) {
  state.counters["error_cm"] = benchmark::Counter(100 * error, benchmark::Counter::kAvgIterations);
  state.counters["evaluations"] = benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}

// Solves for all goals in turn. A library's iterations, which nobody counts, are `of_library`.
void solves(benchmark::CacheState& state, Solver& solver, const Chain& arm, const Problem& problem,
            const std::vector<Goal>& goals, const StopRule& stop, int of_library = 0) {
  Random random{Key(1)};
  double error = 0, evaluations = 0;
  for (auto _ : state) {
    for (const Goal& goal : goals) {
      Objective objective(arm, goal);
      const Solution solution = solve(solver, problem, objective, random, stop);
      error += solution.best.error / static_cast<double>(goals.size());
      evaluations += of_library > 0 ? of_library : static_cast<double>(solution.evaluations);
    }
  }
  count(state, error, evaluations);
}

void registered(benchmark::CacheState& state, const char* name) {
  const Reach reach;
  solves(state, *solver(name).make({}), reach.arm.chain, reach.problem, {reach.target}, {.iterations = iterations});
}

// How often an iteration evaluates all candidates, and draws a number for each of them, or for each of their joints.
struct Needs {
  int evaluations = 1, uniforms = 0, uniforms_of_joints = 0, normals_of_joints = 0;
};

// What no implementation can leave out: the solver's random numbers, and its evaluations in full batches.
void floor(benchmark::CacheState& state, Needs needs) {
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
void growth(benchmark::CacheState& state) {
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

// ---- an iteration, which is an evaluation, towards 50 poses of the Panda by textbook solvers and KDL, and the least
// that one needs

void textbook(benchmark::CacheState& state, const char* name, const Settings& settings, int of_library) {
  const Robot arm = robot("franka_panda");
  const auto& [lower, upper] = arm.limits;
  const Problem problem{.start = (lower + upper) / 2, .lower = lower, .upper = upper};
  std::vector<Goal> goals;
  for (Random random{Key(1)}; goals.size() < 50;) {
    Configuration q(arm.joints());
    draw_one_within_limits(problem, random, q);
    goals.emplace_back(arm.chain.forward(q), 0.3);
  }
  solves(state, *solver(name).make(settings), arm.chain, problem, goals,
         {.iterations = 1000, .tolerance = 1e-6, .angle_tolerance = 1e-6}, of_library);
}

// Forward kinematics, Jacobian and damped step in plain Eigen, with known sizes and the sines of the C library.
void textbook_floor(benchmark::CacheState& state) {
  const Robot arm = robot("franka_panda");
  const Eigen::Matrix<double, 7, 1> goal = (arm.limits.lower + arm.limits.upper) / 2;
  const Pose target = arm.chain.forward(goal);
  Eigen::Matrix<double, 7, 1> q;
  Eigen::Matrix<double, 7, 4> links;
  for (int j = 0; j < 7; ++j) {
    const DhLink& link = arm.chain.links()[static_cast<std::size_t>(j)];
    links.row(j) << link.a, link.d, std::cos(link.alpha), std::sin(link.alpha);
  }
  std::int64_t turn = 0;
  for (auto _ : state) {
    if (turn++ % 10 == 0) q = goal.array() + 0.1;  // a descent
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 7> origins;
    Eigen::Matrix<double, 6, 7> J;
    for (int j = 0; j < 7; ++j) {
      const Eigen::Vector3d z = R.col(2);
      J.col(j).tail<3>() = z;
      origins.col(j) = p;
      const double c = std::cos(q[j]), s = std::sin(q[j]);
      const Eigen::Vector3d x = c * R.col(0) + s * R.col(1), y = c * R.col(1) - s * R.col(0);
      p += links(j, 0) * x + links(j, 1) * z;
      R << x, links(j, 2) * y + links(j, 3) * z, links(j, 2) * z - links(j, 3) * y;
    }
    p += R * arm.chain.tool().position;
    for (int j = 0; j < 7; ++j) J.col(j).head<3>() = J.col(j).tail<3>().cross(p - origins.col(j));
    Eigen::Matrix<double, 6, 1> left;
    left << target.translation() - p, Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) left.tail<3>() += 0.5 * R.col(i).cross(target.linear().col(i));
    Eigen::Matrix<double, 6, 6> damped = J * J.transpose();
    damped.diagonal().array() += 1e-3;
    q += J.transpose() * damped.ldlt().solve(left);
  }
  count(state, (q - goal).norm(), static_cast<double>(state.iterations()));
}

#define TEXTBOOK(name, ...) BENCHMARK_CAPTURE(textbook, name, #name, __VA_ARGS__)->Name("textbook/" #name)
BENCHMARK(textbook_floor)->Name("textbook/floor");
TEXTBOOK(levenberg_marquardt, {}, 0);
TEXTBOOK(damped_least_squares, {}, 0);
TEXTBOOK(newton, {}, 0);
#ifdef IKBENCH_HAS_KDL
TEXTBOOK(kdl_newton, {{"accuracy", 1e-300}, {"iterations", 100.0}}, 100);
#endif

// ---- the whole helix study, slim2023-50: six solvers, 2400 solves, with timing and verifier, without store and
// report; by one thread and by two

void whole_study(benchmark::CacheState& state) {
  const experiments::Study study = experiments::load_study("slim2023-50");
  for (auto _ : state)
    experiments::solve_without_store(study, static_cast<int>(state.range(0)), [](results::SolveRecord) {});
}

BENCHMARK(whole_study)
    ->Name("study/threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ikbench::benchmarks

int main(int argc, char** argv) {
  for (const auto& [key, value] : ikbench::experiments::environment())
    if (key != "date") benchmark::AddCustomContext(key, value);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
