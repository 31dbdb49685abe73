#include "experiments/microbenchmarks/harness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "experiments/environment.hpp"
#include "experiments/study.hpp"
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace experiments;

namespace {

// Prints medians only. Google Benchmark would print mean, median, deviation and every repetition.
class Medians final : public benchmark::ConsoleReporter {
 public:
  Medians() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& reports) override {
    std::vector<Run> shown;
    std::copy_if(reports.begin(), reports.end(), std::back_inserter(shown), [](const Run& report) {
      return report.error_occurred || report.repetitions <= 1 || report.aggregate_name == "median";
    });
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
  }
};

// The built peers, with their versions.
std::string peers() {
  std::set<std::string> libraries;
  for (const SolverInfo& info : all_solvers()) {
    if (!info.library.empty()) libraries.insert(info.library);
  }
  return fmt::format("{}", fmt::join(libraries, ", "));
}

}  // namespace

int run(int argc, char** argv) {
  for (const auto& [key, value] : environment()) {
    if (key != "date") benchmark::AddCustomContext(key, value);
  }
  benchmark::AddCustomContext("peers", peers());
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  Medians console;
  benchmark::RunSpecifiedBenchmarks(&console);
  benchmark::Shutdown();
  return 0;
}

Reach flange_reach() {
  const Robot iiwa = robot("kuka_iiwa14");
  return {iiwa.chain,
          targets(Study{}, 1).front().translation(),
          {.start = Eigen::VectorXd::Zero(7), .lower = iiwa.limits.lower, .upper = iiwa.limits.upper}};
}

Reach snake_reach(int joints, bool slides) {
  std::vector<DhLink> links;
  for (int j = 0; j < joints; ++j) {
    links.push_back(
        {.a = 0.1, .alpha = j % 2 == 0 ? 1.5 : -1.5, .joint = slides && j % 3 == 1 ? Joint::slides : Joint::turns});
  }
  return {Chain(links),
          {0.05 * joints, 0.02 * joints, 0.01},
          {.start = Eigen::VectorXd::Zero(joints),
           .lower = Eigen::VectorXd::Constant(joints, -2),
           .upper = Eigen::VectorXd::Constant(joints, 2)}};
}

Candidates drawn_candidates(const Problem& problem, int count) {
  Candidates candidates(problem.joints(), count);
  Random random{Key(1)};
  draw_within_limits(problem, random, candidates);
  return candidates;
}

bool is_same_position(benchmark::State& state, const Chain& chain, const ConfigurationRef& q,
                      const Eigen::Vector3d& position) {
  const double difference = (chain.position(q) - position).norm();
  if (difference <= 1e-12) return true;
  state.SkipWithError(fmt::format("the position differs from that of our chain by {} m", difference).c_str());
  return false;
}

void count_candidates(benchmark::State& state, int candidates, int joints) {
  using benchmark::Counter;
  state.counters["per_candidate"] =
      Counter(candidates, Counter::Flags(Counter::kIsIterationInvariantRate | Counter::kInvert));
  state.counters["candidate_joints"] = static_cast<double>(candidates) * joints;
}

}  // namespace ikbench::microbenchmarks
