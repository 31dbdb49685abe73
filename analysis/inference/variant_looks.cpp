#include "analysis/inference/variant_looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "analysis/inference/design.hpp"
#include "analysis/statistics/group_sequential.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

// Number of runs, from the first, that both have solved completely.
int runs_in_common(const StudyResults& study) {
  std::map<int, int> solves;
  for (const Solve& solve : study.solves) ++solves[solve.run];
  int run = 0;
  while (solves.contains(run + 1) && solves[run + 1] == 2 * study.points) ++run;
  return run;
}

std::vector<VariantStudy> first_runs(std::span<const VariantStudy> all, int runs) {
  std::vector<VariantStudy> result(all.begin(), all.end());
  for (VariantStudy& each : result) {
    std::erase_if(each.study.solves.to_change(), [&](const Solve& solve) { return solve.run > runs; });
    each.study.runs = runs;
  }
  return result;
}

// A fact of the first runs does not settle later ones.
bool is_settled(const MetricComparison& metric) {
  return metric.is_compared && !metric.contrast.is_fact && !is_open(metric);
}

// Keeps what an earlier look decided.
void keep_settled(std::vector<VariantComparison>& now, const std::vector<VariantComparison>& before) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (std::size_t m = 0; m < before[i].metrics.size(); ++m) {
      if (is_settled(before[i].metrics[m])) now[i].metrics[m] = before[i].metrics[m];
    }
  }
}

}  // namespace

void check_looks(const Looks& looks) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(
        fmt::format("looks after every {} of at most {} runs: {}", looks.step, looks.most, what));
  };
  if (looks.step < 2) refuse("--step is at least 2, because a single run shows no variation");
  if (looks.most < looks.step || looks.most % looks.step != 0) refuse("--max-runs is a multiple of --step");
  if (looks.most / looks.step > most_looks) {
    refuse(fmt::format("there are at most {} looks; choose a larger --step", most_looks));
  }
}

SequentialComparison compare_sequentially(std::span<const VariantStudy> studies, std::span<const std::string> metrics,
                                          const Looks& looks) {
  check_looks(looks);
  int available = looks.most;
  for (const VariantStudy& each : studies) {
    if (blocks_of(each.study) == Blocks::path_targets && each.study.points > 1) {
      throw std::invalid_argument(
          "--sequential adds runs, but here an observation is a target of the path, and runs add no targets; compare "
          "without it");
    }
    available = std::min(available, runs_in_common(each.study));
  }
  if (available < looks.step) {
    throw std::invalid_argument(
        fmt::format("A and B have {} complete runs in common, and the first look is after {}", available, looks.step));
  }
  const Boundary boundary{.looks = looks.most / looks.step};
  std::map<double, double> constants;  // by level
  const auto level_of = [&](double level, int look) {
    const auto [known, is_new] = constants.try_emplace(level);
    if (is_new) known->second = constant_of(level / 2, boundary);
    return 2 * level_of_look(known->second, look, boundary);
  };
  SequentialComparison result;
  for (int look = 1; look * looks.step <= available && result.state != LookState::settled; ++look) {
    result.runs = look * looks.step;
    std::vector<VariantComparison> now = compare_variants(first_runs(studies, result.runs), metrics,
                                                          [&](double level) { return level_of(level, look); });
    keep_settled(now, result.comparisons);
    result.comparisons = std::move(now);
    const auto is_waited_for = [](const MetricComparison& metric) { return metric.is_compared && is_open(metric); };
    if (any_metric(result.comparisons, is_regression) || !any_metric(result.comparisons, is_waited_for)) {
      result.state = LookState::settled;
    }
  }
  if (result.state == LookState::open && result.runs == looks.most) result.state = LookState::at_limit;
  return result;
}

}  // namespace ikbench::inference
