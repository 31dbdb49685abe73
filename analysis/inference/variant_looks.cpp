#include "analysis/inference/variant_looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>

#include "analysis/inference/variant_decision.hpp"
#include "analysis/inference/variant_design.hpp"
#include "analysis/statistics/group_sequential.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

// How many runs, from the first, have every point.
int complete_runs(const Variant& variant) {
  std::map<int, int> points;
  for (const Solve& solve : variant.study.solves) ++points[solve.run];
  int run = 0;
  while (points.contains(run + 1) && points[run + 1] == variant.study.points) ++run;
  return run;
}

int runs_in_common(const std::vector<VariantPair>& pairs) {
  int runs = std::numeric_limits<int>::max();
  for (const auto& [a, b] : pairs) runs = std::min({runs, complete_runs(a), complete_runs(b)});
  return runs;
}

Variant first_runs(const Variant& all, int runs) {
  Variant result{.series = all.series, .study = all.study, .sessions = all.sessions, .timing = all.timing};
  std::erase_if(result.study.solves.to_change(), [&](const Solve& solve) { return solve.run > runs; });
  result.study.runs = runs;
  return result;
}

std::vector<VariantComparison> examine_first(const std::vector<VariantPair>& pairs, int runs,
                                             std::span<const std::string> metrics, const MarginQuestion& question) {
  std::vector<Variant> a, b;
  for (const VariantPair& pair : pairs) {
    a.push_back(first_runs(pair.a, runs));
    b.push_back(first_runs(pair.b, runs));
  }
  std::vector<VariantPair> first;
  for (std::size_t i = 0; i < pairs.size(); ++i) first.push_back({a[i], b[i]});
  return examine_variants(first, metrics, question);
}

// The tests of one metric, and the largest constants that their looks reached so far.
class History {
 public:
  void add(MetricComparison& metric, int look, const Boundary& boundary) {
    const std::array<double*, 4> one_sided{&metric.p_worse, &metric.p_better, &metric.p_not_worse,
                                           &metric.ratio.p_equivalent};
    for (std::size_t i = 0; i < one_sided.size(); ++i) *one_sided[i] = of_all_looks(*one_sided[i], i, look, boundary);
    double& p = metric.ratio.p_difference;  // two-sided
    if (!std::isnan(p)) p = std::min(1.0, 2 * of_all_looks(p / 2, one_sided.size(), look, boundary));
  }

 private:
  double of_all_looks(double p, std::size_t test, int look, const Boundary& boundary) {
    if (std::isnan(p)) return p;
    Reached& reached = reached_[test];
    if (const double constant = constant_of(p, look, boundary); constant > reached.constant) {
      reached = {.constant = constant, .p = chance_to_cross(constant, boundary)};
    }
    return reached.p;
  }

  struct Reached {
    double constant = -std::numeric_limits<double>::infinity();
    double p = 1;
  };
  std::array<Reached, 5> reached_;
};

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

SequentialComparison compare_sequentially(const std::vector<VariantPair>& pairs, std::span<const std::string> metrics,
                                          const MarginQuestion& question, const Looks& looks) {
  check_looks(looks);
  for (const auto& [a, b] : pairs) {
    if (variant_design(a, b).pairs != Blocks::path_targets) continue;
    throw std::invalid_argument(
        "--sequential adds runs, but here an observation is a target of the path, and runs add no targets; compare "
        "without it");
  }
  const int available = std::min(runs_in_common(pairs), looks.most);
  if (available < looks.step) {
    throw std::invalid_argument(
        fmt::format("A and B have {} complete runs in common, and the first look is after {}", available, looks.step));
  }
  const Boundary boundary{.looks = looks.most / looks.step};
  std::vector<std::vector<History>> histories(pairs.size());
  SequentialComparison result;
  for (int look = 1; look * looks.step <= available && result.state != LookState::settled; ++look) {
    result.runs = look * looks.step;
    result.comparisons = examine_first(pairs, result.runs, metrics, question);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      std::vector<MetricComparison>& compared = result.comparisons[i].metrics;
      histories[i].resize(compared.size());
      for (std::size_t m = 0; m < compared.size(); ++m) histories[i][m].add(compared[m], look, boundary);
    }
    decide(result.comparisons, question);
    if (count(result.comparisons, Outcome::worse) > 0 || count(result.comparisons, Outcome::undecided) == 0) {
      result.state = LookState::settled;
    }
  }
  if (result.state == LookState::open && result.runs == looks.most) result.state = LookState::at_limit;
  return result;
}

}  // namespace ikbench::inference
