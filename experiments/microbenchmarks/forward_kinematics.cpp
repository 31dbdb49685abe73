// Position errors of 50 candidates: by our chain, by its limit (a kernel for this arm alone), and one after the other
// by products of 4x4 matrices (Eigen) and by KDL.
#include <benchmark/benchmark.h>

#include "experiments/microbenchmarks/kernels.hpp"
#include "experiments/microbenchmarks/reach.hpp"
#include "numerics/instruction_set.hpp"
#ifdef IKBENCH_HAS_KDL
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#endif

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;

IKBENCH_DEFINE_KERNELS

namespace {

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

}  // namespace

}  // namespace ikbench::microbenchmarks
