// Measures the same candidates by KDL, one at a time, as it is meant to be called. KDL gives the whole pose.
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <vector>

#include "experiments/microbenchmarks/harness.hpp"

namespace ikbench::microbenchmarks {

using namespace robots;
using namespace solvers;

namespace {

KDL::Chain kdl_chain(const Chain& chain) {
  KDL::Chain same;
  for (const DhLink& link : chain.links()) {
    same.addSegment(
        KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame::DH(link.a, link.alpha, link.d, link.offset)));
  }
  return same;
}

void kdl(benchmark::State& state) {
  const Reach reach = flange_reach();
  constexpr int size = 50;
  const Candidates candidates = drawn_candidates(reach.problem, size);
  const KDL::Chain chain = kdl_chain(reach.chain);
  const KDL::Vector target(reach.target.x(), reach.target.y(), reach.target.z());
  KDL::ChainFkSolverPos_recursive solver(chain);
  KDL::Frame pose;
  std::vector<KDL::JntArray> q;
  for (int i = 0; i < size; ++i) {
    q.emplace_back(static_cast<unsigned>(reach.chain.joints()));
    q.back().data = candidates.col(i);
    solver.JntToCart(q.back(), pose);
    if (!is_same_position(state, reach.chain, candidates.col(i), {pose.p.x(), pose.p.y(), pose.p.z()})) return;
  }
  std::vector<double> errors(size);
  for (auto _ : state) {
    for (std::size_t i = 0; i < size; ++i) {
      solver.JntToCart(q[i], pose);
      errors[i] = (pose.p - target).Norm();
    }
    benchmark::DoNotOptimize(errors.data());
    benchmark::ClobberMemory();
  }
  count_candidates(state, size, reach.chain.joints());
}

BENCHMARK(kdl)->Name("forward_kinematics/kdl");

}  // namespace

}  // namespace ikbench::microbenchmarks
